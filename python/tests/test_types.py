"""What people write is right for mypy --strict, and runs."""

import runpy
import subprocess
import sys
from pathlib import Path

import pytest

USE = Path(__file__).parent / "typed_use.py"


def checked(path, folder):
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(folder), str(path)]
    return subprocess.run(command, capture_output=True, text=True, cwd=folder)


def test_mypy(tmp_path):
    pytest.importorskip("mypy")
    found = checked(USE, tmp_path)
    assert found.returncode == 0, found.stdout
    wrong = tmp_path / "wrong.py"
    wrong.write_text('from subcert import Scheme\nScheme("chaikin").contraction("2")\nScheme("chaikin").smoothness().valence\n')
    found = checked(wrong, tmp_path)
    assert found.stdout.count("error:") == 2, found.stdout


def test_it_runs():
    pytest.importorskip("typing_extensions")
    runpy.run_path(str(USE))
