"""Compares refined meshes and their distances with trimesh and compas, which know nothing of subcert.

    cargo build --release --bin subcert
    python3 -m venv target/peers/venv && target/peers/venv/bin/pip install numpy scipy trimesh compas
    target/peers/venv/bin/python benches/peers/meshes.py

Points: every point of our mesh has a point of the peer's at the same place. Distances: the peer refines its
mesh of level k by its own rules, and by its own midpoints, four levels more. The greatest difference of both
at the same vertex is a sample of our distance at level k.
"""

import json
import os
import random
import subprocess
import sys

import numpy
import trimesh
from compas.datastructures import Mesh
from compas.datastructures.mesh.subdivision import (
    mesh_subdivide_catmullclark,
    mesh_subdivide_doosabin,
    mesh_subdivide_quad,
)
from scipy.spatial import cKDTree

PROGRAM, PLACE, MORE = "target/release/subcert", "target/peers", 4


def torus(n, m, triangles, seed):
    numbers = random.Random(seed)
    points = []
    for i in range(n):
        for j in range(m):
            a, b, r = 2 * numpy.pi * i / n, 2 * numpy.pi * j / m, 1 + 0.3 * numbers.random()
            x, y, z = (3 + r * numpy.cos(b)) * numpy.cos(a), (3 + r * numpy.cos(b)) * numpy.sin(a), r * numpy.sin(b)
            points.append([round(float(value), 3) for value in (x, y, z)])
    faces = []
    for i in range(n):
        for j in range(m):
            a, b, c, d = (x % n * m + y % m for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
            # Turned edges make vertices of valences 4 to 8.
            other = numbers.random() < 0.5
            faces += ([[a, b, d], [b, c, d]] if other else [[a, b, c], [a, c, d]]) if triangles else [[a, b, c, d]]
    return points, faces


def cube():
    points = [[x, y, z] for z in (-1.0, 1.0) for y in (-1.0, 1.0) for x in (-1.0, 1.0)]
    points[7] = [1.5, 2.0, 1.25]
    return points, [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


def write(name, points, faces):
    path = f"{PLACE}/{name}.obj"
    with open(path, "w") as file:
        file.writelines("v {} {} {}\n".format(*point) for point in points)
        file.writelines("f " + " ".join(str(vertex + 1) for vertex in face) + "\n" for face in faces)
    return path


def ours(path, scheme, level):
    command = [PROGRAM, "refine", scheme, "--mesh", path, "--level", str(level)]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return numpy.array([[float(x) for x in line.split()[1:]] for line in text.splitlines() if line.startswith("v ")])


def distance(path, scheme, tolerance):
    command = [PROGRAM, "depth", scheme, "--mesh", path, "--tolerance", str(tolerance), "--format", "json"]
    answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    return answer["level"], *(float(answer["distance"][end]) for end in ("lower", "upper"))


def loop(points, faces, level, linear=False):
    refine = trimesh.remesh.subdivide if linear else trimesh.remesh.subdivide_loop
    vertices, faces = numpy.array(points), numpy.array(faces)
    for _ in range(level):
        vertices, faces = refine(vertices, faces)[:2] if linear else refine(vertices, faces, iterations=1)
    return vertices, faces


def compas(rule, points, faces, level):
    mesh = Mesh.from_vertices_and_faces(points, faces)
    return rule(mesh, k=level) if level else mesh


def positions(mesh):
    return numpy.array([mesh.vertex_coordinates(key) for key in sorted(mesh.vertices())])


def farthest(left, right):
    """The greatest distance of a point of one from the nearest point of the other, both ways."""
    return max(cKDTree(right).query(left)[0].max(), cKDTree(left).query(right)[0].max())


def main():
    os.makedirs(PLACE, exist_ok=True)
    quads, triangles = torus(7, 5, False, 1), torus(7, 6, True, 2)
    print("| mesh | scheme | peer | farthest points, levels 1 to 3 | level | peer's sample | our bounds |")
    print("|---|---|---|--:|--:|--:|--:|")
    bad = False
    for name, mesh, scheme, tolerance in (
        ("cube", cube(), "catmull-clark", 0.05),
        ("torus", quads, "catmull-clark", 0.05),
        ("cube", cube(), "doo-sabin", 0.05),
        ("torus", quads, "doo-sabin", 0.05),
        ("torus of triangles", triangles, "loop", 0.05),
    ):
        path = write(f"{name}-{scheme}".replace(" ", "-"), *mesh)
        level, lower, upper = distance(path, scheme, tolerance)
        peer, sample = "compas", None
        if scheme == "loop":
            peer = "trimesh"
            levels = [loop(*mesh, k)[0] for k in (1, 2, 3)]
            here = loop(*mesh, level)
            (smooth, faces), (flat, same) = (loop(*here, MORE, linear) for linear in (False, True))
            assert (faces == same).all()
            sample = numpy.linalg.norm(smooth - flat, axis=1).max()
        else:
            rule = mesh_subdivide_doosabin if scheme == "doo-sabin" else mesh_subdivide_catmullclark
            levels = [positions(compas(rule, *mesh, k)) for k in (1, 2, 3)]
            if scheme == "catmull-clark":
                here = compas(rule, *mesh, level)
                smooth, flat = rule(here, k=MORE), mesh_subdivide_quad(here, k=MORE)
                assert set(smooth.vertices()) == set(flat.vertices())
                sample = numpy.linalg.norm(positions(smooth) - positions(flat), axis=1).max()
        far = max(farthest(ours(path, scheme, k + 1), points) for k, points in enumerate(levels))
        found = "" if sample is None else f"{sample:.5f}"
        print(f"| {name} | {scheme} | {peer} | {far:.1e} | {level} | {found} | {lower:.5f} to {upper:.5f} |")
        bad = bad or far > 1e-9 or (sample is not None and not 0.98 * lower < sample < 1.001 * upper)
    sys.exit("our values and the peer's differ" if bad else 0)


main()
