# Tests a refinement in Julia against reference values:
#   subcert oracle chaikin --level 5 > chaikin.json
#   julia chaikin.jl chaikin.json
using JSON

function my_chaikin(points, levels)
    for _ in 1:levels
        next = circshift(points, -1)
        points = vec(permutedims([0.75points + 0.25next 0.25points + 0.75next]))
    end
    points
end

oracle = JSON.parsefile(ARGS[1])

# `hex` is the nearest Float64 itself.
values_of(quantity) = [parse(Float64, value["hex"])
                       for group in oracle["groups"] if group["quantity"] == quantity
                       for value in group["values"]]

# p/q, as a rational number of any size.
exact(text) = //(parse.(BigInt, occursin('/', text) ? split(text, '/') : (text, "1"))...)

expected = values_of("refined")
found = my_chaikin(values_of("control"), oracle["header"]["level"])
@assert length(found) == length(expected)
@assert all(abs.(found - expected) .<= 4eps.(expected))
println(length(expected), " points agree")
