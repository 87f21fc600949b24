"""The time and peak memory of a command."""

import os
import subprocess
import sys
import time


def measure(command, output=subprocess.DEVNULL):
    """Wall and processor seconds, and the peak memory in MiB as last seen; what the command writes goes to `output`.

    `ru_maxrss` would be no less than the memory of this script."""
    start, peak = time.perf_counter(), 0
    child = subprocess.Popen(command, stdout=output)
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
