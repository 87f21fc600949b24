#!/bin/sh
# Compares subcert with python-flint, PARI/GP, SymPy and plain Python integers: the same exact
# values, and one table of ratios of times. The Python packages go into target/peers, and so does
# gp on Debian, unless it is on the path. What is missing is named and left out.
set -eu
cd "$(dirname "$0")/../.."
place=target/peers
mkdir -p "$place"
python3 -m venv "$place/venv" 2>/dev/null || echo "missing: python3 with venv" >&2
for package in python-flint sympy; do
    "$place/venv/bin/pip" install --quiet --disable-pip-version-check "$package" 2>/dev/null ||
        echo "missing: $package, and no network to install it" >&2
done
PATH="$PATH:$PWD/$place/gp/usr/bin"
if ! command -v gp >/dev/null; then
    (cd "$place" && apt-get download -qq pari-gp && dpkg -x pari-gp_*.deb gp) >/dev/null 2>&1 ||
        echo "missing: gp (Debian: pari-gp), and no network to get it" >&2
fi
cargo run --release --quiet --example peers > "$place/subcert.json"
"$place/venv/bin/python" benches/peers/compare.py "$place/subcert.json"
