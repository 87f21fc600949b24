"""Time and peak memory of the headline runs, as one table.

    cargo build --release --bin subcert --examples && python3 benches/headlines.py
"""

import subprocess

from measure import measure

PROGRAM = "target/release/subcert"
SEARCH, VALENCE = "target/release/examples/search", "target/release/examples/valence"
SCHEMES = subprocess.check_output([SEARCH, "schemes"], text=True).split()
RUNS = [
    ("start (--help)", [PROGRAM, "--help"]),
    ("audit of the five papers", [PROGRAM, "audit"]),
    *((f"T, Λ and joint, c = 64: {scheme}", [SEARCH, scheme, "64"]) for scheme in SCHEMES),
    *((f"T, Λ and joint, c = 256: {scheme}", [SEARCH, scheme, "256"]) for scheme in SCHEMES),
    ("Doo–Sabin faces, n = 3…500, c = 1…5", [VALENCE]),
    *(
        (f"Doo–Sabin face, n = {n}, c = 1…5", [PROGRAM, "constants", f"doo-sabin:n={n}", "-c", "5"])
        for n in (5, 100, 499, 500)
    ),
]


def main():
    print("| run | seconds | of a processor | peak MiB |\n|---|--:|--:|--:|")
    for name, command in RUNS:
        runs = [measure(command)]
        while len(runs) < 5 and sum(run[0] for run in runs) < 1:
            runs.append(measure(command))
        seconds, used = (min(run[i] for run in runs) for i in (0, 1))
        memory = max(run[2] for run in runs)
        print(f"| {name} | {seconds:.3g} | {used:.3g} | {memory:.1f} |", flush=True)


main()
