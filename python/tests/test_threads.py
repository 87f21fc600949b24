"""Long work leaves other threads alone, and ends on Ctrl-C."""

import signal
import subprocess
import sys
import threading
import time

import pytest

import subcert

LONG = 'subcert.audit("mustafa2020-nary")'


def test_other_threads_run():
    ticks = []
    done = threading.Event()

    def tick():
        while not done.wait(0.005):
            ticks.append(time.monotonic())

    thread = threading.Thread(target=tick)
    thread.start()
    begin = time.monotonic()
    subcert.audit("mustafa2020-nary")
    passed = time.monotonic() - begin
    done.set()
    thread.join()
    # A tick every 5 ms, if nothing holds the lock; a tenth of them will do on a busy machine.
    assert len([t for t in ticks if t >= begin]) >= passed / 0.05


# Who is started in the background of a shell ignores interrupts, and so do those it starts.
START = """
import os, signal, threading, time
from fractions import Fraction
import subcert
from subcert import Scheme, jsr

signal.signal(signal.SIGINT, signal.default_int_handler)
cube = [(x, y, z / 7) for z in (-1, 1) for y in (-1, 1) for x in (-1, 2)]
faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]

def rules(count, width):
    "Rules without any symmetry."
    rows = [[Fraction((7 * i * i + 13 * i * j + 29 * j * j) % 61 - 20, 97) for j in range(width - 1)] for i in range(count)]
    return [row + [1 - sum(row)] for row in rows]

def matrices(count, size):
    return [[[(i * i + 3 * i * j + 7 * j * k + k * k * i) % 19 - 9 for k in range(size)] for j in range(size)] for i in range(count)]
"""

#: Each takes far longer than a second.
JOBS = {
    "contraction": "Scheme(mask=[['3/10', '7/10', '-1/10', '1/10'], ['-1/7', '3/7', '4/7', '1/7']]).contraction(200)",
    "smoothness": "Scheme(mask=rules(4, 12)).smoothness()",
    "facts": "subcert.scheme('kobbelt')",
    "audit": "subcert.audit('mustafa2020-nary')",
    "jsr": "jsr(matrices(6, 30))",
    "range": "Scheme('six-point').range('w', levels=9)",
    "refine": "Scheme('four-point').refine([(i * i % 7 / 3, i % 5 / 7) for i in range(400)], 9)",
    "refine_mesh": "subcert.refine_mesh('catmull-clark', cube, faces, 8)",
    "mesh_depth": "subcert.mesh_depth('catmull-clark', cube, faces, '1e-7')",
    "geometric": "subcert.mesh_geometric_depth('catmull-clark', cube, faces, '1e-5')",
    "certify": "Scheme('six-point', w='0.01').certify(22)",
}


@pytest.mark.parametrize("job", JOBS.values(), ids=JOBS.keys())
def test_nothing_goes_on_after_an_interrupt(job):
    code = f"""{START}
threading.Timer(0.7, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    {job}
    print("finished")
except KeyboardInterrupt:
    pass
time.sleep(1.2)
begin = time.process_time()
time.sleep(0.4)
print(time.process_time() - begin)
# What comes later is not stopped.
assert Scheme("four-point").smoothness().continuity == 1
assert subcert.audit("khan2019-newton").summary["confirmed"] == 6
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=100)
    assert found.returncode == 0 and found.stderr == ""
    assert float(found.stdout) < 0.05


@pytest.mark.parametrize("job", [LONG, JOBS["contraction"], JOBS["jsr"]])
def test_interrupts_end_the_work(job):
    code = f"{START}\nprint('ready', flush=True)\n{job}\nprint('finished')"
    process = subprocess.Popen(
        [sys.executable, "-c", code],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.2)
    begin = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert "KeyboardInterrupt" in err and "finished" not in out and "panicked" not in err
    assert time.monotonic() - begin < 5
