#!/usr/bin/env python3
"""Forty small defects, each of which some test has to catch: how strong the tests are.

    .ci/defects.py [NUMBER ...]

The defects go into a copy of the repository, in target/defects. There each is a switch that the variable
SUBCERT_DEFECT turns on, so that one build serves all. The tests near a defect run first, and all tests if these pass.
A run ends at the first test that fails. Documentation tests do not run. A defect with which the tests take longer
than LIMIT seconds is caught too. Each is printed as a row of a table, and one that no test catches fails the run.
Without numbers, all tests run first without any defect: they have to pass.
"""

import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "target" / "defects"
LIMIT = 400
CARGO = ["cargo", "test", "--test", "tests"]
# No failing case is simplified, or kept for the next run.
ENVIRONMENT = {"CARGO_TARGET_DIR": str(ROOT / "target" / "defects-build"), **os.environ, "SUBCERT_CASES": "all",
               "PROPTEST_MAX_SHRINK_ITERS": "0", "PROPTEST_DISABLE_FAILURE_PERSISTENCE": "true"}

# The file, an expression that occurs there once, the expression in its place, and the names of tests to run first.
DEFECTS = [
    ("src/numbers/exact/printed/decimal.rs", "off.plus(&off) <= unit", "off.plus(&off) < unit", "exact::decimal"),
    ("src/numbers/exact/parameter/interval_set.rs", "2 * place(low) + 2", "2 * place(low) + 1", "exact:: formula::"),
    ("src/numbers/machine/convert.rs", "!floor.is_even()", "false", "float::convert"),
    ("src/numbers/exact/real/cyclotomic/order.rs", "&sum - &error", "sum.clone()", "exact::"),
    ("src/numbers/exact/real/algebraic/number.rs", "candidate > self.lower && self.polynomial.sign_at(&candidate) == 0",
     "self.polynomial.sign_at(&candidate) == 0", "exact::algebraic"),
    ("src/numbers/exact/parameter/piecewise.rs", "signs[i] != signs[i + 1] || zeros.binary_search(point).is_ok()",
     "signs[i] != signs[i + 1]", "exact::piecewise"),
    ("src/numbers/exact/polynomials/univariate.rs", "if negative { -top } else { top }", "top", "exact::univariate"),
    ("src/numbers/formula/builtin.rs", "top.minus(&V::from_rational(&Rational::from(i)))",
     "top.plus(&V::from_rational(&Rational::from(i)))", "formula::"),
    ("src/schemes/bound/sound.rs", "first.tensor_with(second, c)?.max(second.tensor_with(first, c)?)",
     "first.tensor_with(second, c)?", "bound::sound bound::surface"),
    ("src/schemes/bound/extreme/exact_rows.rs", "(base - &offset) * &arity", "base * &arity", "bound::extreme"),
    ("src/schemes/limit/natural.rs", "number(Rational::new(1, 2))", "number(Rational::zero())", "limit::natural"),
    ("src/schemes/smoothness/exponent.rs", "hull.bound < limit", "hull.bound <= limit", "smoothness::"),
    ("src/schemes/spectrum/jordan.rs", "cosines[k].plus(&cosines[k])", "cosines[k].clone()", "spectrum::"),
    ("src/schemes/characteristic/vertex.rs", "found.multiplicity == 1", "true", "characteristic::"),
    ("src/schemes/float/apriori.rs", "self.error.max(other.error)", "self.error", "float::apriori"),
    ("src/schemes/scheme/local/symmetry.rs", "same_weights && same_edges", "same_weights", "scheme::local_rules"),
    ("src/schemes/characteristic/positive.rs", "if side > 0 { (end, free) } else { (free, end) }", "(end, free)",
     "characteristic::"),
    ("src/geometry/mesh/crease/tags.rs", "Rational::from(count - 1)", "Rational::from(count)", "mesh::creases"),
    ("src/geometry/mesh/crease/blend.rs", "connectivity.edges()[edge].ends.into_iter().all(stays)",
     "connectivity.edges()[edge].ends.into_iter().any(stays)", "mesh::creases"),
    ("src/geometry/mesh/limit/dart.rs", "&edges[(i + 1) % n]", "&edges[(i + n - 1) % n]", "mesh::creases"),
    ("src/geometry/mesh/region.rs", "*i <= at || !star.boundary", "*i <= at", "mesh:: patch::geometric"),
    ("src/schemes/limit/window.rs", "(-short).ceil()", "(-short).floor()", "limit:: net::"),
    ("src/geometry/patch/shapes/neighbourhood.rs", "*end >= inside", "*end > inside", "patch::creases"),
    ("src/geometry/patch/shapes/ring.rs", "is_cut[i] && is_cut[next]", "is_cut[i] || is_cut[next]", "patch::creases"),
    ("src/geometry/patch/distance/judge.rs", "self.below(vector, level) > self.tolerance[1]",
     "self.above(vector, level) > self.tolerance[1]", "patch::exactness patch::nets::exactness"),
    ("src/geometry/patch/hexes/guarantee.rs", "0.75 + later(1)", "later(1)", "patch::solids"),
    ("src/claims/judge/compare.rs", "i + 1 < printed.len()", "i < printed.len()", "judge::numbers"),
    ("src/claims/judge/reading/chance.rs", "(m.saturating_sub(self.silent) as u64).cast_signed()", "(m as u64).cast_signed()",
     "judge::readings"),
    ("src/claims/digest/luck.rs", "others && Rational::from(explained) <= by_luck",
     "Rational::from(explained) <= by_luck", "digest::luck"),
    ("src/claims/judge/theorem/growth.rs", "if divides { -other.spreads } else { other.spreads }", "other.spreads",
     "judge::theorem"),
    ("src/claims/judge/range.rs", "self.claim.closed.is_none_or(|closed| closed == belongs)", "true",
     "judge::functions_and_ranges"),
    ("src/claims/judge/promise.rs", "matches!(of, PromiseKind::Tolerance(_))", "false", "audit::papers"),
    ("src/claims/shipped/number.rs", "if negative { -i128::from(bits) } else { i128::from(bits) }",
     "i128::from(bits)", "shipped::"),
    ("src/reports/certificate/coq/numbers.rs", "number.is_integer() && number.sign() >= 0", "number.is_integer()",
     "certificate::coq"),
    ("src/reports/certificate/witness.rs", "axis + 1", "axis + 0", "certificate::theorems certificate::papers"),
    ("src/cli/smoothness/jsr.rs", "!is_comment && !last.is_empty()", "!last.is_empty()", "cli::smoothness"),
    ("src/cli/depth/masks.rs", "arguments.boundary != Some(DepthBoundary::Polygon(BoundaryArgument::Open))", "true",
     "cli::bad_input"),
    ("proofs/checker/src/sets/near.rs", "distance + radius + more <= TOLERANCE", "distance + more <= TOLERANCE",
     "certificate::depth"),
    ("proofs/checker/src/kinds/range/mod.rs", "*sign < 0 || *sign == 0 && !below", "*sign <= 0", "rules::"),
    ("proofs/checker/src/kinds/theorem/growth.rs", "own.equals(&other)? && whole.2 == next.2", "own.equals(&other)?",
     "rules::"),
]

SWITCH = """
extern crate self as NAME;

/// Whether the defect of this number is turned on.
#[must_use]
pub fn defect(number: usize) -> bool {
    static TURNED_ON: std::sync::OnceLock<Option<usize>> = std::sync::OnceLock::new();
    let read = || std::env::var("SUBCERT_DEFECT").ok()?.parse().ok();
    *TURNED_ON.get_or_init(read) == Some(number)
}
"""


def sources() -> dict[str, bytes | str]:
    """Every file of the repository, with the switches; of a link, where it leads."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    paths = [ROOT / name for name in listed.split("\0") if name and os.path.lexists(ROOT / name)]
    files = {str(path.relative_to(ROOT)): os.readlink(path) if path.is_symlink() else path.read_bytes()
             for path in paths}
    for number, (name, old, new, _) in enumerate(DEFECTS, 1):
        text, krate = files[name].decode(), "subcert_check" if name.startswith("proofs") else "subcert_numbers"
        if text.count(old) != 1:
            sys.exit(f"defect {number}: {name} has {text.count(old)} times {old}")
        switched = f"(if {krate}::defect({number}) {{ {new} }} else {{ {old} }})"
        files[name] = text.replace(old, switched).encode()
    for name, krate in [("src/numbers/lib.rs", "subcert_numbers"), ("proofs/checker/src/lib.rs", "subcert_check")]:
        files[name] += SWITCH.replace("NAME", krate).encode()
    return files


def write(files: dict[str, bytes | str]) -> None:
    """Makes the copy; a file that is the same stays, so that it is not compiled again."""
    for path in COPY.rglob("*"):
        if path.is_file() and str(path.relative_to(COPY)) not in files:
            path.unlink()
    for name, content in files.items():
        path = COPY / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, str):
            path.unlink(missing_ok=True)
            path.symlink_to(content)
        elif not path.exists() or path.read_bytes() != content:
            path.write_bytes(content)


def fails(number: int, names: list[str], limit: float) -> str | None:
    """What fails first in the two programs of tests, with a defect; None if nothing does."""
    # The switches are imports, which the tests of the architecture would count.
    process = subprocess.Popen([*CARGO, "--", *names, "--skip", "architecture"], cwd=COPY, env=ENVIRONMENT | {"SUBCERT_DEFECT": str(number)},
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, start_new_session=True)
    late = threading.Event()

    def stop() -> None:
        late.set()
        os.killpg(process.pid, signal.SIGKILL)

    timer = threading.Timer(limit, stop)
    timer.start()
    failed = None
    for line in process.stdout:
        if line.rstrip().endswith("FAILED"):
            failed = line.removeprefix("test ").split(" ")[0]
            os.killpg(process.pid, signal.SIGKILL)
            break
    code = process.wait()
    timer.cancel()
    return failed or ("time" if late.is_set() else f"exit code {code}" if code else None)


def main() -> int:
    numbers = [int(word) for word in sys.argv[1:]]
    write(sources())
    subprocess.run([*CARGO, "--quiet", "--no-run"], cwd=COPY, env=ENVIRONMENT, check=True)
    if not numbers and (failed := fails(0, [], 10 * LIMIT)):
        sys.exit(f"without a defect: {failed}")
    print("| | file | defect | caught by | seconds |\n|--:|---|---|---|--:|", flush=True)
    missed = 0
    for number in numbers or range(1, len(DEFECTS) + 1):
        name, old, new, near = DEFECTS[number - 1]
        start = time.monotonic()
        failed = fails(number, near.split(), LIMIT)
        failed = failed or fails(number, [], LIMIT - (time.monotonic() - start))
        missed += failed is None
        change = f"`{old}` → `{new}`".replace("|", "\\|")
        caught = f"`{failed}`" if failed else "**not caught**"
        seconds = time.monotonic() - start
        print(f"| {number} | `{name}` | {change} | {caught} | {seconds:.0f} |", flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
