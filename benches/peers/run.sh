#!/bin/sh
# Compares subcert with python-flint, PARI/GP, SymPy and plain Python integers: the same exact
# values, and one table of ratios of times. The Python packages go into target/peers; gp is
# taken from the path (Debian: apt install pari-gp). What is missing is named and left out.
set -eu
cd "$(dirname "$0")/../.."
place=target/peers
mkdir -p "$place"
python3 -m venv "$place/venv" 2>/dev/null || echo "missing: python3 with venv" >&2
for package in python-flint sympy; do
    "$place/venv/bin/pip" install --quiet --disable-pip-version-check "$package" 2>/dev/null ||
        echo "missing: $package, and no network to install it" >&2
done
command -v gp >/dev/null || echo "missing: gp (Debian: apt install pari-gp)" >&2
cargo run --release --quiet --example peers > "$place/subcert.json"
"$place/venv/bin/python" benches/peers/compare.py "$place/subcert.json"
