#!/usr/bin/env python3
"""Reference values in Octave, C, C++ and Rust: runs the examples of docs/languages.md, and reads every number back.

    .ci/languages.py [PROGRAM]

PROGRAM is target/release/subcert without it. Octave and the JSON library of C++ come from Debian where they
are missing.
"""

import csv
import json
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EXAMPLES = ROOT / "examples" / "languages"
HEADER = Path("/usr/include/nlohmann/json.hpp")

# Points of three coordinates, with numbers that no double is equal to.
POINTS = "0 0 1/3\n1 1/7 0\n2/3 5 -1\n-1 0.1 9e-300\n"

TETRAHEDRON = "OFF\n4 4 0\n0 0 1/3\n1 1/7 0\n0 2 0.1\n-1 -1 -1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n"

# Writes the bits of every number of the function NAME, row by row.
BITS = """
values = NAME();
names = fieldnames(values);
for at = 1:numel(names)
  array = values.(names{at});
  if isnumeric(array)
    bits = cellstr(num2hex(array'));
    printf('%s %s\\n', names{at}, strjoin(bits', ' '));
  end
end
"""


def install() -> None:
    sudo = [] if os.geteuid() == 0 else ["sudo"]
    subprocess.run([*sudo, "apt-get", "update", "-qq"], check=True)
    packages = ["octave", "nlohmann-json3-dev"]
    subprocess.run([*sudo, "apt-get", "install", "-y", "-qq", "--no-install-recommends", *packages], check=True)


def octave(code: str, folder: Path) -> subprocess.CompletedProcess[str]:
    command = ["octave-cli", "--quiet", "--eval", code]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def oracle(program: str, folder: Path, form: str, *arguments: str) -> str:
    command = [program, "oracle", *arguments, "--format", form]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout


def implementations(program: str, folder: Path) -> None:
    """The examples agree with the reference values, and a wrong one does not."""
    (folder / "oracle_chaikin.m").write_text(oracle(program, folder, "matlab", "chaikin", "--level", "5"))
    right = octave("oracle_chaikin(@my_chaikin)", folder)
    assert right.returncode == 0 and "256 values agree" in right.stdout, right
    wrong = octave("oracle_chaikin(@(points, levels) my_chaikin(points, levels) + 1e-12)", folder)
    assert wrong.returncode == 1 and "exact       " in wrong.stderr, wrong
    short = octave("oracle_chaikin(@(points, levels) my_chaikin(points, levels - 1))", folder)
    assert short.returncode == 1 and "should be [256 1]" in short.stderr, short
    closed = ["chaikin", "--level", "3", "--polygon", "points.txt"]
    (folder / "oracle_chaikin.m").write_text(oracle(program, folder, "matlab", *closed))
    points = octave("oracle_chaikin(@my_chaikin)", folder)
    assert points.returncode == 0 and "96 values agree" in points.stdout, points

    (folder / "chaikin.json").write_text(oracle(program, folder, "json", "chaikin", "--level", "5"))
    compiler = ["g++", "-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "chaikin.cpp", "-o", "chaikin"]
    subprocess.run(compiler, cwd=folder, check=True)
    subprocess.run(["./chaikin", "chaikin.json"], cwd=folder, check=True)


def numbers(program: str, folder: Path, *arguments: str) -> None:
    """Every double that Octave reads is the one in the column `hex` of the table."""
    text = oracle(program, folder, "matlab", *arguments)
    name = text.split("=")[1].split("(")[0].strip()
    (folder / f"{name}.m").write_text(text)
    done = octave(BITS.replace("NAME", name), folder)
    assert done.returncode == 0, done.stderr
    found = {quantity: bits for quantity, *bits in map(str.split, done.stdout.splitlines())}
    expected: dict[str, list[str]] = {}
    for row in csv.DictReader(oracle(program, folder, "table", *arguments).splitlines()):
        double = float.fromhex(row["hex"])
        assert float(row["value"]) == double, row
        expected.setdefault(row["quantity"], []).append(struct.pack(">d", double).hex())
    columns: dict[str, list[list[str]]] = {}
    for quantity, bits in expected.items():
        head, _, number = quantity.rpartition("-")
        columns.setdefault(head if number.isdigit() else quantity, []).append(bits)
    rows = {
        quantity.replace("-", "_"): [bit for row in zip(*parts, strict=True) for bit in row]
        for quantity, parts in columns.items()
    }
    assert rows == found, (rows, found)
    print(f"{name}: {sum(map(len, rows.values()))} numbers are the same in Octave")


C = ["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror"]
RUST = ["rustc", "--edition", "2021", "-D", "warnings"]

# The declaration of an array of numbers, with its name and its sizes.
ARRAYS = {
    "h": re.compile(r"^static const double (\w+)((?:\[\d+\])+) =", re.MULTILINE),
    "rs": re.compile(r"^pub static (\w+): (\[+f64[; \]\d]+) =", re.MULTILINE),
}


def compiled(command: list[str], folder: Path) -> str:
    """What a program prints that a compiler makes without a warning."""
    done = subprocess.run([*command, "-o", "compiled"], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, (command, done.stderr)
    return subprocess.run(["./compiled"], cwd=folder, capture_output=True, text=True, check=True).stdout


def bits_in_c(names: list[str], _shapes: list[str], folder: Path) -> str:
    """Prints the bits of every number; the header is read twice, and by itself."""
    (folder / "alone.c").write_text((folder / "values.h").read_text())
    for source in ("alone.c", "values.h"):
        subprocess.run([*C, "-fsyntax-only", source], cwd=folder, check=True)
    lines = [f'    bits("{name}", (const double *){name}, sizeof {name} / sizeof(double));' for name in names]
    (folder / "main.c").write_text(
        """#include "values.h"
#include "values.h"
#include <stdint.h>
#include <stdio.h>
#include <string.h>
static void bits(const char *name, const double *values, size_t count) {
    printf("%s", name);
    for (size_t i = 0; i < count; i++) {
        uint64_t one;
        memcpy(&one, values + i, sizeof one);
        printf(" %016llx", (unsigned long long)one);
    }
    puts("");
}
int main(void) {
"""
        + "\n".join(lines)
        + "\n    return 0;\n}\n"
    )
    # long long is of C99, and so is its conversion.
    return compiled([*C, "main.c"], folder)


def bits_in_rust(names: list[str], shapes: list[str], folder: Path) -> str:
    subprocess.run([*RUST, "--crate-type", "lib", "--emit", "metadata", "values.rs"], cwd=folder, check=True)
    flat = {False: "iter()", True: "iter().flatten()"}
    lines = [
        f'    print!("{name}"); for x in values::{name}.{flat[shape.startswith("[[")]} {{ print!(" {{:016x}}", x.to_bits()); }}'
        " println!();"
        for name, shape in zip(names, shapes)
    ]
    # Once as a module, of which not all is used, and once as a part of one.
    text = 'mod values;\nmod part { include!("values.rs"); }\nfn main() {\n' + "\n".join(lines)
    (folder / "main.rs").write_text(text + '\n    assert_eq!(part::LEVEL, values::LEVEL);\n}\n')
    return compiled([*RUST, "main.rs"], folder)


def expected_of_groups(answer: dict) -> dict[str, list[float]]:
    columns: dict[str, list[list[float]]] = {}
    for group in answer["groups"]:
        head, _, number = group["quantity"].rpartition("-")
        name = (head if number.isdigit() else group["quantity"]).replace("-", "_")
        columns.setdefault(name, []).append([float.fromhex(value["hex"]) for value in group["values"]])
    return {name: [x for row in zip(*parts, strict=True) for x in row] for name, parts in columns.items()}


def expected_of_mesh(answer: dict) -> dict[str, list[float]]:
    limits = [limit for limit in answer["limits"] if limit]
    points = lambda all: [float(x) for point in all for x in point["f64"]]
    found = {"points": points(answer["points"])}
    # A solid has limit points alone.
    if limits and "position" not in limits[0]:
        return found | {"limits": points(limits)}
    normals = [limit["normal"]["unit_f64"] for limit in limits if limit["normal"]]
    more = {"limits": points(limit["position"] for limit in limits), "normals": [float(x) for n in normals for x in n]}
    return found | {name: values for name, values in more.items() if values}


def sources(program: str, folder: Path, *arguments: str) -> None:
    """C and Rust compile without a warning, and hold the doubles of the JSON and their units in the last place."""
    answer = json.loads(oracle(program, folder, "json", *arguments))
    expected = expected_of_groups(answer) if "groups" in answer else expected_of_mesh(answer)
    for name in ("refined", "points", "limits"):
        if name in expected:
            expected[f"{name}_ulp"] = [math.ulp(x) for x in expected[name]]
    for ending, bits in (("h", bits_in_c), ("rs", bits_in_rust)):
        # The ending decides.
        command = [program, "oracle", *arguments, "-o", f"values.{ending}"]
        subprocess.run(command, cwd=folder, check=True, capture_output=True)
        text = (folder / f"values.{ending}").read_text()
        names, shapes = zip(*ARRAYS[ending].findall(text))
        prefix = re.search(r"#ifndef SUBCERT_(\w+)_H", text)
        prefix = f"{prefix[1].lower()}_" if prefix else ""
        found = {}
        for line in bits(names, shapes, folder).splitlines():
            name, *values = line.split()
            numbers = [struct.unpack(">d", bytes.fromhex(value))[0] for value in values]
            found[name.lower().removeprefix(prefix)] = [x.hex() for x in numbers]
        # The control points are those of the file.
        mesh = found.pop("control_points", None)
        assert (mesh is None) == ("groups" in answer)
        assert found == {name: [x.hex() for x in values] for name, values in expected.items()}, (arguments, ending)
        print(f"{' '.join(arguments)}: {sum(map(len, found.values()))} numbers are the same in {ending}")


def own_tests(program: str, folder: Path) -> None:
    """The tests in C and Rust of docs/languages.md pass, and do not with a wrong weight."""
    for ending in ("h", "rs"):
        command = [program, "oracle", "chaikin", "--level", "5", "-o", f"oracle_chaikin.{ending}"]
        subprocess.run(command, cwd=folder, check=True)
    for command, source in (([*C, "my_chaikin.c", "-lm"], "my_chaikin.c"), ([*RUST, "--test", "my_chaikin.rs"], "my_chaikin.rs")):
        path = folder / source
        for text, code in ((path.read_text(), False), (path.read_text().replace("0.75", "0.7500001"), True)):
            path.write_text(text)
            subprocess.run([*command, "-o", "own"], cwd=folder, check=True)
            done = subprocess.run(["./own"], cwd=folder, capture_output=True, text=True)
            assert bool(done.returncode) == code and (not code or "in place of" in done.stdout), (source, done)


def main() -> int:
    program = str((ROOT / (sys.argv[1] if len(sys.argv) > 1 else "target/release/subcert")).resolve())
    if not shutil.which("octave-cli") or not HEADER.exists():
        install()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for example in EXAMPLES.iterdir():
            shutil.copy(example, folder)
        (folder / "points.txt").write_text(POINTS)
        implementations(program, folder)
        numbers(program, folder, "four-point:w=1/17", "--level", "4", "--polygon", "points.txt")
        numbers(program, folder, "six-point:w=3/257 x chaikin", "--level", "2")
        numbers(program, folder, "doo-sabin:n=5", "--level", "3")
        own_tests(program, folder)
        points = ["--level", "4", "--polygon", "points.txt"]
        examples = ROOT / "examples"
        sources(program, folder, "four-point:w=1/17", *points)
        sources(program, folder, "[1, 3, 3, 1]/4", "--boundary", "open")
        sources(program, folder, "six-point:w=3/257 x chaikin")
        sources(program, folder, "doo-sabin:n=5", "--level", "3")
        sources(program, folder, "catmull-clark", "--mesh", str(examples / "cube.obj"))
        sources(program, folder, "doo-sabin", "--mesh", str(examples / "tent.obj"), "--level", "1")
        (folder / "tetrahedron.off").write_text(TETRAHEDRON)
        sources(program, folder, "loop", "--mesh", "tetrahedron.off", "--level", "1")
        sources(program, folder, "bicubic", "--mesh", str(examples / "roof.csv"), "--level", "1")
        sources(program, folder, "bajaj", "--mesh", str(examples / "star.vtk"), "--level", "1")
    return 0


if __name__ == "__main__":
    sys.exit(main())
