"""Long work leaves other threads alone, and ends on Ctrl-C."""

import signal
import subprocess
import sys
import textwrap
import threading
import time

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


def test_interrupts_end_the_work():
    # Who is started in the background of a shell ignores interrupts, and so do those it starts.
    heed = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    code = f"{heed}; import subcert; print('ready', flush=True); {LONG}; print('finished')"
    process = subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(code)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.2)
    begin = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert "KeyboardInterrupt" in err and "finished" not in out
    assert time.monotonic() - begin < 5
