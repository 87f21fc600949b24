// Refines a mesh with OpenSubdiv in double, and prints what .ci/opensubdiv.py compares with subcert.
//
// opensubdiv SCHEME LEVEL < TEXT, where TEXT has the lines `v x y z`, `f i j k …`, `crease i j s`,
// `corner i s`, `hole i`, `boundary 0|1|2` (none, edge, corner) and `chaikin`, all numbers from 0.
//
// For each level before the last it prints where the children of vertices, edges and faces are, and
// for each level its points; then limit points and tangents of the last level.
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>

#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace OpenSubdiv;

struct Point {
    double x[3];
    void Clear(void * = 0) { x[0] = x[1] = x[2] = 0; }
    void AddWithWeight(Point const &p, double w) {
        for (int i = 0; i < 3; ++i) x[i] += w * p.x[i];
    }
};

static void print(char const *name, std::vector<Point> const &points) {
    for (Point const &p : points) std::printf("%s %.17g %.17g %.17g\n", name, p.x[0], p.x[1], p.x[2]);
}

int main(int argc, char **argv) {
    if (argc != 3) return 2;
    bool loop = std::string(argv[1]) == "loop";
    int level = std::atoi(argv[2]);
    std::vector<Point> points;
    std::vector<int> counts, corners, creaseEnds, cornerVertices, holes;
    std::vector<float> creaseSharpness, cornerSharpness;
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
    std::string line, word;
    while (std::getline(std::cin, line)) {
        std::istringstream in(line);
        in >> word;
        int i, j;
        float s;
        if (word == "v") {
            Point p;
            in >> p.x[0] >> p.x[1] >> p.x[2];
            points.push_back(p);
        } else if (word == "f") {
            counts.push_back(0);
            while (in >> i) {
                corners.push_back(i);
                ++counts.back();
            }
        } else if (word == "crease" && in >> i >> j >> s) {
            creaseEnds.push_back(i);
            creaseEnds.push_back(j);
            creaseSharpness.push_back(s);
        } else if (word == "corner" && in >> i >> s) {
            cornerVertices.push_back(i);
            cornerSharpness.push_back(s);
        } else if (word == "hole" && in >> i) {
            holes.push_back(i);
        } else if (word == "boundary" && in >> i) {
            options.SetVtxBoundaryInterpolation(Sdc::Options::VtxBoundaryInterpolation(i));
        } else if (word == "chaikin") {
            options.SetCreasingMethod(Sdc::Options::CREASE_CHAIKIN);
        }
    }
    Far::TopologyDescriptor mesh;
    mesh.numVertices = int(points.size());
    mesh.numFaces = int(counts.size());
    mesh.numVertsPerFace = counts.data();
    mesh.vertIndicesPerFace = corners.data();
    mesh.numCreases = int(creaseSharpness.size());
    mesh.creaseVertexIndexPairs = creaseEnds.data();
    mesh.creaseWeights = creaseSharpness.data();
    mesh.numCorners = int(cornerSharpness.size());
    mesh.cornerVertexIndices = cornerVertices.data();
    mesh.cornerWeights = cornerSharpness.data();
    mesh.numHoles = int(holes.size());
    mesh.holeIndices = holes.data();
    typedef Far::TopologyRefinerFactory<Far::TopologyDescriptor> Factory;
    Sdc::SchemeType type = loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK;
    Far::TopologyRefiner *refiner = Factory::Create(mesh, Factory::Options(type, options));
    if (!refiner) return 3;
    Far::TopologyRefiner::UniformOptions uniform(level);
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);
    Far::PrimvarRefinerReal<double> primvar(*refiner);
    for (int k = 0; k < level; ++k) {
        Far::TopologyLevel const &now = refiner->GetLevel(k);
        for (int i = 0; i < now.GetNumVertices(); ++i)
            std::printf("vertex %d %d\n", i, now.GetVertexChildVertex(i));
        for (int i = 0; i < now.GetNumEdges(); ++i) {
            Far::ConstIndexArray ends = now.GetEdgeVertices(i);
            std::printf("edge %d %d %d\n", ends[0], ends[1], now.GetEdgeChildVertex(i));
        }
        for (int i = 0; i < now.GetNumFaces() && !loop; ++i) {
            std::printf("face %d", now.GetFaceChildVertex(i));
            Far::ConstIndexArray own = now.GetFaceVertices(i);
            for (int j = 0; j < own.size(); ++j) std::printf(" %d", own[j]);
            std::printf("\n");
        }
        std::vector<Point> next(refiner->GetLevel(k + 1).GetNumVertices());
        primvar.Interpolate(k + 1, points, next);
        points.swap(next);
        std::printf("level %d\n", k + 1);
        print("v", points);
    }
    Far::TopologyLevel const &last = refiner->GetLevel(level);
    for (int i = 0; i < last.GetNumFaces(); ++i) {
        if (!last.IsFaceHole(i)) continue;
        std::printf("hole");
        Far::ConstIndexArray own = last.GetFaceVertices(i);
        for (int j = 0; j < own.size(); ++j) std::printf(" %d", own[j]);
        std::printf("\n");
    }
    std::vector<Point> limits(points.size()), first(points.size()), second(points.size());
    primvar.Limit(points, limits, first, second);
    print("limit", limits);
    print("t1", first);
    print("t2", second);
    delete refiner;
    return 0;
}
