"""Time and peak memory of `subcert depth --mesh` on large meshes, made from a seed.

    cargo build --release --bin subcert && python3 benches/meshes.py

Tori of quadrilaterals have regular vertices only. Where each face of a torus of triangles is cut into three
quadrilaterals, half of the vertices have the valence 3 or 6.
"""

import math
import os
import random
import tempfile

from measure import measure

PROGRAM, PLACE = "target/release/subcert", "target/meshes"


def torus(n, m, seed):
    """The points of a torus with bumps."""
    numbers = random.Random(seed)
    for i in range(n):
        for j in range(m):
            a, b = 2 * math.pi * i / n, 2 * math.pi * j / m
            r = 1 + 0.02 * numbers.random()
            yield (3 + r * math.cos(b)) * math.cos(a), (3 + r * math.cos(b)) * math.sin(a), r * math.sin(b)


def corners(n, m):
    """The quadrilaterals of a torus, counted from 1."""
    for i in range(n):
        for j in range(m):
            yield [x % n * m + y % m + 1 for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))]


def cut(points, faces):
    """Quadrilaterals cut into two triangles, and each of these into three quadrilaterals."""
    points, middles, result = list(points), {}, []

    def mean(*numbers):
        key = tuple(sorted(numbers))
        if key not in middles:
            ends = [points[number - 1] for number in numbers]
            points.append(tuple(sum(x) / len(ends) for x in zip(*ends)))
            middles[key] = len(points)
        return middles[key]

    for a, b, c, d in faces:
        for face in ((a, b, c), (a, c, d)):
            for i in range(3):
                p, q, r = face[i], face[(i + 1) % 3], face[(i + 2) % 3]
                result.append([p, mean(p, q), mean(*face), mean(r, p)])
    return points, result


def halved(faces):
    """Quadrilaterals cut into two triangles."""
    for a, b, c, d in faces:
        yield from ((a, b, c), (a, c, d))


def write(name, points, faces):
    path = f"{PLACE}/{name}.obj"
    with open(path, "w") as file:
        file.writelines("v %.6f %.6f %.6f\n" % point for point in points)
        file.writelines("f " + " ".join(map(str, face)) + "\n" for face in faces)
    return path


def main():
    os.makedirs(PLACE, exist_ok=True)
    quads = write("quads", torus(400, 250, 1), corners(400, 250))
    mixed = write("mixed", *cut(torus(130, 128, 2), corners(130, 128)))
    triangles = write("triangles", torus(300, 166, 3), halved(corners(300, 166)))
    million = write("million", torus(1000, 1000, 4), corners(1000, 1000))
    runs = [
        ("100,000 quadrilaterals", "catmull-clark", quads, "2e-4", []),
        ("100,000 quadrilaterals", "doo-sabin", quads, "2e-4", []),
        ("99,840 quadrilaterals, half of the vertices irregular", "catmull-clark", mixed, "2e-3", []),
        ("the same", "doo-sabin", mixed, "2e-3", []),
        ("99,600 triangles", "loop", triangles, "2e-4", []),
        ("1,000,000 quadrilaterals, a priori", "catmull-clark", million, "2e-4", ["--a-priori"]),
    ]
    print("| mesh | scheme | ε | distance | levels | seconds | of a processor | peak MiB |")
    print("|---|---|--:|---|--:|--:|--:|--:|")
    each = ["parametric", "geometric"]
    runs = [(*run, distance) for run in runs for distance in each if not run[4] or distance == each[0]]
    for name, scheme, path, tolerance, more, distance in runs:
        command = [PROGRAM, "depth", scheme, "--mesh", path, "--tolerance", tolerance, "--format", "json"]
        command += ["--distance", distance]
        with tempfile.TemporaryFile("w+") as output:
            seconds, used, memory = measure([*command, *more], output)
            output.seek(0)
            text = output.read()
        values = [line.split(":")[1].strip(" ,") for line in text.splitlines() if '"level":' in line]
        level = values[0] if values[0] != "null" else f"{values[-1]} a priori"
        print(f"| {name} | {scheme} | {tolerance} | {distance} | {level} | {seconds:.2f} | {used:.2f} | {memory:.0f} |", flush=True)


main()
