#!/usr/bin/env python3
"""Compares refinement and limits with OpenSubdiv (Debian: libosd-dev), on random creased meshes.

    opensubdiv.py SUBCERT [COUNT]

Points of levels 1 to 4, holes, limit points and normals of COUNT meshes for each scheme must agree. What
docs/meshes.md calls a convention of OpenSubdiv is compared apart, and must be as it says there.
"""
import json, math, random, subprocess, sys, tempfile
from fractions import Fraction
from pathlib import Path

HERE = Path(__file__).parent
BOUNDARIES = ["none", "edge", "corner"]
LEVELS = 4
# Sharpness is a float in OpenSubdiv, and so is the mean of three, which is seldom a dyadic number.
BOUND = 1e-7


def build(folder):
    program = Path(folder) / "opensubdiv"
    source = HERE / "opensubdiv.cpp"
    subprocess.run(["g++", "-O1", "-std=c++14", source, "-losdCPU", "-o", program], check=True)
    return program


def grid(rows, columns, triangles):
    faces = []
    for i in range(rows - 1):
        for j in range(columns - 1):
            a, b, c, d = (i * columns + j, i * columns + j + 1, (i + 1) * columns + j + 1, (i + 1) * columns + j)
            faces += [[a, b, c], [a, c, d]] if triangles else [[a, b, c, d]]
    return rows * columns, faces


def bipyramid(n):
    return n + 2, [f for i in range(n) for f in ([i, (i + 1) % n, n], [(i + 1) % n, i, n + 1])]


def fan(n):
    """n triangles around a vertex."""
    return n + 1, [[n, i, (i + 1) % n] for i in range(n)]


def prism(n):
    sides = [[i, (i + 1) % n, (i + 1) % n + n, i + n] for i in range(n)]
    return 2 * n, [list(range(n))[::-1], [i + n for i in range(n)]] + sides


def star(n):
    """n quadrilaterals around a vertex."""
    return 2 * n + 1, [[0, 1 + i, 1 + n + i, 1 + (i + 1) % n] for i in range(n)]


def shape(draw, triangles):
    if triangles:
        return draw.choice([lambda: bipyramid(draw.randint(3, 7)), lambda: fan(draw.randint(3, 9)),
                            lambda: grid(draw.randint(2, 4), draw.randint(2, 4), True)])()
    return draw.choice([lambda: prism(draw.randint(3, 7)), lambda: star(draw.randint(3, 8)),
                        lambda: grid(draw.randint(2, 4), draw.randint(2, 5), draw.random() < 0.3),
                        lambda: bipyramid(draw.randint(3, 6))])()


def edges_of(faces):
    numbers = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            numbers.setdefault(frozenset((a, b)), len(numbers))
    return numbers


def mesh(draw, triangles):
    count, faces = shape(draw, triangles)
    points = [[draw.randint(-64, 64) / 16 for _ in range(3)] for _ in range(count)]
    edges = [sorted(edge) for edge in edges_of(faces)]
    sharpness = lambda: draw.choice([draw.randint(1, 24) / 8, draw.randint(1, 24) / 8, 10])
    creases = [(*edge, sharpness()) for edge in edges if draw.random() < draw.choice([0, 0.2, 0.5])]
    if draw.random() < 0.4:
        # A closed or long crease: edges of one sharpness along the boundary of a face.
        face, sharp = draw.choice(faces), sharpness()
        ring = {frozenset(pair) for pair in zip(face, face[1:] + face[:1])}
        creases = [(a, b, s) for a, b, s in creases if frozenset((a, b)) not in ring]
        creases += [(*sorted(edge), sharp) for edge in ring]
    corners = [(v, sharpness()) for v in range(count) if draw.random() < 0.08]
    holes = [f for f in range(len(faces)) if draw.random() < 0.05]
    return dict(points=points, faces=faces, creases=sorted(creases), corners=corners, holes=holes,
                boundary=draw.randrange(3), chaikin=draw.random() < 0.4)


def as_obj(mesh):
    lines = ["v {} {} {}".format(*p) for p in mesh["points"]]
    lines += ["f " + " ".join(str(v + 1) for v in face) for face in mesh["faces"]]
    lines += ["t crease 2/1/0 {} {} {}".format(*crease) for crease in mesh["creases"]]
    lines += ["t corner 1/1/0 {} {}".format(*corner) for corner in mesh["corners"]]
    lines += ["t hole 1/0/0 {}".format(hole) for hole in mesh["holes"]]
    lines.append("t interpolateboundary 1/0/0 {}".format([0, 2, 1][mesh["boundary"]]))
    if mesh["chaikin"]:
        lines.append("t creasemethod 0/0/1 chaikin")
    return "\n".join(lines) + "\n"


def as_text(mesh):
    lines = ["v {!r} {!r} {!r}".format(*p) for p in mesh["points"]]
    lines += ["f " + " ".join(map(str, face)) for face in mesh["faces"]]
    lines += ["crease {} {} {}".format(*crease) for crease in mesh["creases"]]
    lines += ["corner {} {}".format(*corner) for corner in mesh["corners"]]
    lines += ["hole {}".format(hole) for hole in mesh["holes"]]
    lines += ["boundary {}".format(mesh["boundary"])] + ["chaikin"] * mesh["chaikin"]
    return "\n".join(lines) + "\n"


def subcert(program, command, scheme, path, level):
    said = subprocess.run([program, command, scheme, "--mesh", path, "--level", str(level), "--format", "json"],
                          capture_output=True, text=True)
    if said.returncode:
        raise SystemExit(f"{path}: {said.stderr}")
    return json.loads(said.stdout)


def f64(point):
    return [float(x) for x in point["f64"]]


def opensubdiv(program, scheme, level, mesh):
    said = subprocess.run([program, scheme, str(level)], input=as_text(mesh), capture_output=True, text=True, check=True)
    levels, lists = [dict(vertex={}, edge={}, face={}, points=[])], dict(limit=[], t1=[], t2=[], hole=[])
    for line in said.stdout.splitlines():
        name, *rest = line.split()
        if name == "level":
            levels.append(dict(vertex={}, edge={}, face={}, points=[]))
        elif name == "v":
            levels[-1]["points"].append([float(x) for x in rest])
        elif name == "vertex":
            levels[-1]["vertex"][int(rest[0])] = int(rest[1])
        elif name == "edge":
            levels[-1]["edge"][frozenset((int(rest[0]), int(rest[1])))] = int(rest[2])
        elif name == "face":
            levels[-1]["face"][frozenset(map(int, rest[1:]))] = int(rest[0])
        elif name == "hole":
            lists["hole"].append(frozenset(map(int, rest)))
        else:
            lists[name].append([float(x) for x in rest])
    return levels, lists


def renumbered(levels, meshes, scheme):
    """For each level, which point of OpenSubdiv a point of subcert is: vertices, edges, faces."""
    own = list(range(len(meshes[0]["points"])))
    yield own
    for k in range(len(levels) - 1):
        children, faces = levels[k], meshes[k]["faces"]
        next_ = [children["vertex"][v] for v in own]
        next_ += [children["edge"][frozenset(own[v] for v in edge)] for edge in edges_of(faces)]
        if scheme != "loop":
            next_ += [children["face"][frozenset(own[v] for v in face)] for face in faces]
        own = next_
        yield own


def distance(p, q):
    return max(abs(a - b) for a, b in zip(p, q))


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def unit(p):
    length = math.sqrt(sum(x * x for x in p))
    return [x / length for x in p] if length > 1e-9 else None


class Worst(dict):
    def see(self, name, value):
        count, worst = self.get(name, (0, 0.0))
        self[name] = (count + 1, max(worst, value))


def infinite_edges(mesh):
    """The number of infinitely sharp edges at each vertex."""
    faces_at = {}
    for face in mesh["faces"]:
        for edge in zip(face, face[1:] + face[:1]):
            faces_at[frozenset(edge)] = faces_at.get(frozenset(edge), 0) + 1
    sharp = {edge for edge, count in faces_at.items() if count == 1}
    sharp |= {frozenset((a, b)) for a, b, s in mesh["creases"] if s >= 10}
    count = [0] * len(mesh["points"])
    for edge in sharp:
        for v in edge:
            count[v] += 1
    return count


def above_one(now, later):
    """Whether an edge of finite sharpness above 1 has a smooth half at the next level (Chaikin's rule)."""
    numbers, count = edges_of(now["faces"]), len(now["points"])
    sharp = {frozenset(crease["vertices"]) for crease in later.get("creases", [])}
    for crease in now.get("creases", []):
        ends = crease["vertices"]
        middle = count + numbers[frozenset(ends)]
        if 1 < Fraction(crease["sharpness"]) < 10 and any(frozenset((end, middle)) not in sharp for end in ends):
            return True
    return False


def compare(ours, theirs, scheme, mesh, path, worst):
    meshes = [subcert(ours, "refine", scheme, path, k) for k in range(LEVELS + 1)]
    levels, lists = opensubdiv(theirs, scheme, LEVELS, mesh)
    numbers = list(renumbered(levels, meshes, scheme))
    kind = "chaikin" if mesh["chaikin"] else "uniform"
    for k in range(1, LEVELS + 1):
        if mesh["chaikin"] and above_one(meshes[k - 1], meshes[k]):
            worst.see("meshes where OpenSubdiv has a weight above 1", 0.0)
            return
        for mine, own in zip(meshes[k]["points"], numbers[k]):
            worst.see(f"{kind}, level {k}", distance(f64(mine), levels[k]["points"][own]))
    last = numbers[LEVELS]
    holes = {frozenset(last[v] for v in meshes[LEVELS]["faces"][hole]) for hole in meshes[LEVELS].get("holes", [])}
    worst.see("holes", len(holes ^ set(lists["hole"])))
    deep = subcert(ours, "limit", scheme, path, LEVELS)["limits"]
    early = subcert(ours, "limit", scheme, path, 0)["limits"]
    sharp = infinite_edges(mesh)
    cornered = {v for v, s in mesh["corners"] if s >= 10}
    for v, (limit, own) in enumerate(zip(deep, last)):
        dart = v < len(sharp) and sharp[v] == 1 and v not in cornered
        name = "darts" if dart else "limits"
        error = distance(f64(limit["position"]), lists["limit"][own])
        worst.see(f"{kind}, {name}", error)
        if v < len(sharp):
            worst.see(f"{kind}, limit of level 0", distance(f64(early[v]["position"]), f64(limit["position"])))
        theirs_normal = unit(cross(lists["t1"][own], lists["t2"][own]))
        sectors = limit.get("sectors", [])
        if sectors:
            regular = 2 if scheme == "catmull-clark" else 3
            # OpenSubdiv's tangents are those of one sector.
            sizes = {len(sector["faces"]) for sector in sectors}
            found = [[float(x) for x in s["normal"]["unit_f64"]] for s in sectors if s["normal"]]
            name = "crease normals" if max(sizes) <= regular else "irregular crease normals"
            if limit["position"]["exact"] == meshes[LEVELS]["points"][v]["exact"]:
                name = "normals of corners"
        else:
            found = [[float(x) for x in limit["normal"]["unit_f64"]]] if limit["normal"] else []
            name = "normals"
        if found and theirs_normal:
            worst.see(f"{kind}, {name}", min(distance(one, theirs_normal) for one in found))


def main():
    ours, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 30
    failures, total = [], Worst()
    with tempfile.TemporaryDirectory() as folder:
        theirs = build(folder)
        for scheme in ["catmull-clark", "loop"]:
            for number in range(count):
                draw = random.Random(f"{scheme} {number}")
                path = Path(folder) / "mesh.obj"
                one = mesh(draw, scheme == "loop")
                path.write_text(as_obj(one))
                worst = Worst()
                compare(ours, theirs, scheme, one, path, worst)
                for name, (seen, error) in worst.items():
                    before, most = total.get(f"{scheme}: {name}", (0, 0.0))
                    total[f"{scheme}: {name}"] = (before + seen, max(most, error))
                    if "darts" in name or "irregular" in name or "of corners" in name:
                        continue
                    if error > BOUND:
                        failures.append(f"{scheme} {number}: {name} differs by {error:.3g}")
    for name, (seen, error) in sorted(total.items()):
        print(f"{name:55} {seen:7} compared, at most {error:.3g} apart")
    if failures:
        raise SystemExit("\n".join(failures[:40]))


main()
