"""Time and peak memory of the headline runs, as one table.

    cargo build --release --bin subcert --examples && python3 benches/headlines.py
"""

import os
import subprocess
import sys
import time

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


def measure(command):
    """Wall and processor seconds, and the peak memory in MiB as last seen.

    `ru_maxrss` would be no less than the memory of this script."""
    start, peak = time.perf_counter(), 0
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    while True:
        ended, status, usage = os.wait4(child.pid, os.WNOHANG)
        if ended:
            break
        with open(f"/proc/{child.pid}/status") as lines:
            peaks = [int(line.split()[1]) for line in lines if line.startswith("VmHWM")]
        peak = max([peak, *peaks])
        time.sleep(0.0005)
    seconds = time.perf_counter() - start
    if status:
        sys.exit(f"{' '.join(command)} fails")
    return seconds, usage.ru_utime + usage.ru_stime, peak / 1024


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
