// Tests a refinement in C++ against reference values:
//   subcert oracle chaikin --level 5 > chaikin.json
//   g++ -std=c++17 chaikin.cpp -o chaikin && ./chaikin chaikin.json
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

std::vector<double> my_chaikin(std::vector<double> points, int levels) {
    for (int level = 0; level < levels; ++level) {
        std::vector<double> refined;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double here = points[i], next = points[(i + 1) % points.size()];
            refined.push_back(0.75 * here + 0.25 * next);
            refined.push_back(0.25 * here + 0.75 * next);
        }
        points = refined;
    }
    return points;
}

// The values of a quantity. `hex` is the nearest double itself: strtod reads it without rounding.
std::vector<double> values_of(const nlohmann::json& oracle, const std::string& quantity) {
    std::vector<double> values;
    for (const auto& group : oracle.at("groups"))
        if (group.at("quantity") == quantity)
            for (const auto& value : group.at("values"))
                values.push_back(std::strtod(value.at("hex").get<std::string>().c_str(), nullptr));
    return values;
}

// The unit in the last place of a double.
double ulp(double value) {
    const double size = std::abs(value);
    return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: chaikin FILE.json\n";
        return 2;
    }
    std::ifstream file(argv[1]);
    const auto oracle = nlohmann::json::parse(file);
    const auto expected = values_of(oracle, "refined");
    const auto found = my_chaikin(values_of(oracle, "control"), oracle.at("header").at("level"));
    if (found.size() != expected.size()) {
        std::cerr << found.size() << " points in place of " << expected.size() << "\n";
        return 1;
    }
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!(std::abs(found[i] - expected[i]) <= 4 * ulp(expected[i]))) {
            std::cerr << "point " << i << " is " << found[i] << " in place of " << expected[i] << "\n";
            return 1;
        }
    std::cout << expected.size() << " points agree\n";
}
