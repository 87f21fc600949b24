#!/usr/bin/env python3
"""Reference values in Octave and C++: runs the examples of docs/languages.md, and reads every number back.

    .ci/languages.py [PROGRAM]

PROGRAM is target/release/subcert without it. Octave and the JSON library of C++ come from Debian where they
are missing.
"""

import csv
import os
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
    return 0


if __name__ == "__main__":
    sys.exit(main())
