"""Compares `subcert jsr` with the Python program jsr of D. Tarnu, an implementation of the invariant
polytope algorithm in f64: known sets of matrices, and random pairs from a seed.

    python3 -m venv target/peers/jsr
    target/peers/jsr/bin/pip install git+https://github.com/D-Tarnu/jsr@9f3b9d0
    cargo build --release
    target/peers/jsr/bin/python benches/peers/jsr.py

A line has the set, our bounds and whether they meet, our seconds, the peer's value and seconds, and
whether the value is within 1e-6 of our bounds. The peer stops with an answer, without one, or after
`LIMIT` seconds. Its seconds leave out the time to load its libraries.
"""

import json
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LIMIT = 20
PROGRAM = Path(__file__).resolve().parents[2] / "target/release/subcert"

KNOWN = {
    # Ahmadi, Jungers, Parrilo, Roozbehani 2014.
    "pair of AJPR14": [[[-1, -1], [-4, 0]], [[3, 3], [-2, 1]]],
    "autocorrelations of Rudin-Shapiro": [
        [[1, 0, 2], [-1, 0, 2], [0, 1, 0]],
        [[0, 1, 0], [0, -1, 0], [1, 0, 0]],
    ],
    # Guglielmi, Zennaro 2009.
    "pair of Guglielmi and Zennaro": [
        [[-3, -2, 1, 2], [-2, 0, -2, 1], [1, 3, -1, -5], [-3, -3, -2, -1]],
        [[1, 0, -3, -1], [-4, -2, -1, -4], [-1, 0, -1, 2], [-1, -2, -1, 2]],
    ],
}

PEER = """
import json, sys, time
from contextlib import redirect_stdout
from io import StringIO
from jsr import invar_poly
matrices = json.load(sys.stdin)
start = time.perf_counter()
with redirect_stdout(StringIO()):
    value = invar_poly(matrices, 10, 10)
print(json.dumps([None if value is None else float(value), time.perf_counter() - start]))
"""


def random_pairs():
    """Ten pairs for each size from 2 to 4, with entries from -3 to 3."""
    source = random.Random(20261123)
    for size in (2, 3, 4):
        for number in range(10):
            rows = lambda: [[source.randint(-3, 3) for _ in range(size)] for _ in range(size)]
            yield f"{size}x{size}, number {number}", [rows(), rows()]


def ours(matrices):
    text = "\n\n".join("\n".join(" ".join(map(str, row)) for row in rows) for rows in matrices)
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        file.write(text + "\n")
        file.flush()
        start = time.perf_counter()
        command = [PROGRAM, "jsr", file.name, "--format", "json"]
        found = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
        seconds = time.perf_counter() - start
    return found, seconds


def theirs(matrices):
    command = [sys.executable, "-c", PEER]
    try:
        run = subprocess.run(
            command, input=json.dumps(matrices), capture_output=True, text=True, timeout=LIMIT
        )
    except subprocess.TimeoutExpired:
        return None, LIMIT
    if run.returncode != 0:
        return run.stderr.strip().splitlines()[-1], 0.0
    return json.loads(run.stdout)


def main():
    print("| set | subcert | meets | seconds | peer | seconds | agrees |")
    print("|---|---|---|--:|--:|--:|---|")
    for name, matrices in list(KNOWN.items()) + list(random_pairs()):
        found, seconds = ours(matrices)
        value, their_seconds = theirs(matrices)
        low, high = float(found["lower"]), float(found["upper"])
        if isinstance(value, float):
            agrees = "yes" if low - 1e-6 <= value <= high + 1e-6 else "no"
        else:
            agrees = ""
        bounds = f"{low:.6f}" if found["exact"] else f"{low:.6f} to {high:.6f}"
        print(
            f"| {name} | {bounds} | {'yes' if found['exact'] else 'no'} | {seconds:.3f} "
            f"| {'' if value is None else value} | {their_seconds:.3f} | {agrees} |",
            flush=True,
        )


if __name__ == "__main__":
    main()
