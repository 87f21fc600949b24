#!/usr/bin/env python3
"""Compiles the Coq library and the theorems of the papers, and tests that wrong numbers are rejected.

Without `coqc` it says so, and does nothing. Otherwise, with J jobs at a time (as many as there are cores):

- no file says one of FORBIDDEN, and no file that the papers import says one of RENAMING or gives a name of Definitions.v
  another meaning;
- every file compiles, in a copy of proofs/coq;
- `Print Assumptions` of every theorem of the papers is closed: no axiom at all. The theorems about limits over R may
  use the axioms of the real numbers of the standard library, ALLOWED, and no others;
- a theorem with one number changed is not accepted: at least LEAST_MUTATIONS of them.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COQ = ROOT / "proofs" / "coq"
FORBIDDEN = [
    "Admitted", "admit", "Axiom", "Axioms", "Conjecture", "Parameter", "Parameters", "Hypotheses", "native_compute", "BigZ", "BigN",
    "BigQ", "Int63", "Uint63", "PArray", "bypass_check", "Unset Guard", "Unset Universe", "Unset Positivity", "type_in_type", "Declare ML",
]
# What could change the meaning of a statement that is written after it.
RENAMING = [
    "Notation", "Infix", "Coercion", "Canonical", "Arguments", "Bind", "Delimit", "Declare", "Export", "Global", "Instance", "Set", "Unset",
    "Module", "Include", "Load",
]
IMPORTED = ["Definitions", "Core", "Error", "Depth", "Refutation", "Net", "Ring"]
DEFINED = re.compile(r"\b(?:Definition|Fixpoint|Record|Inductive|Lemma|Theorem|Example|Ltac)\s+(\w+)")
ALLOWED = {
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
}
# Of a library file that states limits over R.
OVER_REALS = {"Limit"}
LEAST_MUTATIONS = 20
THEOREM = re.compile(r"^(?:Theorem|Example) (\w+)", re.MULTILINE)


def library() -> list[str]:
    """The files of the library, in their order."""
    lines = (COQ / "_CoqProject").read_text().splitlines()
    return [line.removesuffix(".v") for line in lines if line.endswith(".v")]


def without_comments(text: str) -> str:
    kept, depth, i = [], 0, 0
    while i < len(text):
        if text.startswith("(*", i):
            depth, i = depth + 1, i + 2
        elif depth and text.startswith("*)", i):
            depth, i = depth - 1, i + 2
        else:
            if not depth:
                kept.append(text[i])
            i += 1
    return "".join(kept)


def renaming() -> str | None:
    """What could give a name of a statement another meaning than that of Definitions.v, if anything."""
    # This only says what the tactic `simpl` leaves as it is.
    harmless = re.compile(r"^#\[global\] Arguments [\w.]+ : simpl never\.$", re.MULTILINE)
    texts = {name: harmless.sub("", without_comments((COQ / f"{name}.v").read_text())) for name in IMPORTED}
    meanings = set(DEFINED.findall(texts["Definitions"]))
    for name, text in texts.items():
        for word in RENAMING:
            if re.search(rf"(?<!\w){word}(?!\w)", text):
                return f"{name}.v: `{word}` is not allowed where papers import it"
        if re.search(r"^\s*Open Scope", text, re.MULTILINE):
            return f"{name}.v: a scope is opened for others too"
        again = meanings & set(DEFINED.findall(text)) if name != "Definitions" else set()
        if again:
            return f"{name}.v: {', '.join(again)} of Definitions.v again"
    return None


def coqc(folder: Path, file: Path) -> subprocess.CompletedProcess:
    return subprocess.run(
        ["coqc", "-q", "-Q", str(folder), "Subcert", "-w", "-cannot-open-path,-deprecated", str(file)],
        cwd=folder, capture_output=True, text=True, timeout=600,
    )


def questions(text: str) -> str:
    """A file's text with `Print Assumptions` of its theorems at its end."""
    return text + "".join(f"\nPrint Assumptions {name}." for name in THEOREM.findall(without_comments(text)))


def assumptions(output: str) -> set[str]:
    """What the answers to `Print Assumptions` name."""
    return set(re.findall(r"^([\w.]+)\s*:", output, re.MULTILINE)) - {"Axioms"}


def changed(text: str) -> list[tuple[str, str]]:
    """What was changed, and the text with the first theorem of each kind that has one number changed by one unit."""
    bare = text
    found = []

    def put(start: int, end: int, new: str, what: str) -> None:
        found.append((what, bare[:start] + new + bare[end:]))

    # A weight of a mask, or of a ring.
    mask = re.search(r"(?:Scheme \d+ \(-?\d+\)|Ring \d+) \[\[(-?\d+)", bare)
    if mask:
        put(*mask.span(1), str(int(mask[1]) + 1), "a weight")
    for kind, step in KINDS.items():
        statement = re.search(rf"^Theorem \w+ :\s+{kind} [^.]*?\(?(-?\d+) # (\d+)\)?\.$", bare, re.MULTILINE)
        if statement:
            number = int(statement[1]) + step
            start, end = statement.span(1)
            # The lemma may repeat the number.
            head, tail = bare[:start], bare[end:]
            again = tail.split("Qed.", 1)[0]
            fixed = again.replace(f"({statement[1]} # {statement[2]})", f"({number} # {statement[2]})")
            found.append((f"{kind}, its number", head + str(number) + fixed + tail[len(again) :]))
    # At natural parameters: the shift, where the data leave it no room, and the bound plus 1, which no distance of spread 1 exceeds there.
    natural = re.compile(
        r"^\(\* \w+ at natural parameters .*\nTheorem \w+ :\s+exceeds_(\w+) (?:scheme_\d+ )+(\((-?\d+) # (\d+)\)).* \((\d+) # (\d+)\)\.$", re.MULTILINE
    ).search(bare)
    if natural:
        end = bare.index("Qed.", natural.start())
        kind, shift, top, bottom, over, under = natural.groups()
        bound = f"({over} # {under})"
        ways = [("the natural bound", bound, f"({int(over) + int(under)} # {under})")]
        if kind == "distance":
            ways.append(("the natural shift", shift, f"({int(top) - 1} # {bottom})"))
        for what, old, new in ways:
            found.append((what, bare[: natural.start()] + bare[natural.start() : end].replace(old, new) + bare[end:]))
    depth = re.search(r"^Theorem \w+ :\s+sufficient_depth .* (\d+)\.$", bare, re.MULTILINE)
    if depth and int(depth[1]) > 0:
        put(*depth.span(1), str(int(depth[1]) - 1), "sufficient_depth, its level")
    return found


# Where one unit more, or less, in the numerator of the last number is wrong. Others have room, so that a unit may be right.
KINDS = {
    "contraction_constant": 1,
    "backwards_constant": -1,
    "scheme_norm": 1,
    "bounds_distance": -1,
}


def main() -> int:
    if not shutil.which("coqc"):
        print("SKIPPED: there is no coqc here; `apt-get install coq libcoq-stdlib` has one")
        return 0
    started = time.monotonic()
    files = [*(COQ / f"{name}.v" for name in library()), *sorted(COQ.glob("papers/*/*.v"))]
    strangers = set(COQ.rglob("*.v")) - set(files)
    if strangers:
        sys.exit(f"not in _CoqProject: {', '.join(map(str, strangers))}")
    for file in files:
        bare = without_comments(file.read_text())
        for word in FORBIDDEN:
            if re.search(rf"(?<!\w){word}(?!\w)", bare):
                sys.exit(f"{file}: `{word}` is not allowed")
    if wrong := renaming():
        sys.exit(wrong)
    papers = [file for file in files if file.parent != COQ]
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(os.cpu_count()) as pool:
        copy = Path(name)
        for library_file in library():
            text = (COQ / f"{library_file}.v").read_text()
            (copy / f"{library_file}.v").write_text(text)
            compile_one(copy, copy / f"{library_file}.v", questions(text), library_file in OVER_REALS)
        print(f"the library: {len(library())} files, {time.monotonic() - started:.0f} s")

        def theorems(file: Path) -> tuple[Path, int, float]:
            begun = time.monotonic()
            target = copy / file.relative_to(COQ)
            text = file.read_text()
            compile_one(copy, target, questions(text), False)
            return file, len(THEOREM.findall(text)), time.monotonic() - begun

        counts: dict[str, list[int]] = {}
        for file, count, seconds in pool.map(theorems, papers):
            counts.setdefault(file.parent.name, []).append(count)
            if seconds > 20:
                print(f"{file.relative_to(COQ)}: {seconds:.0f} s")
        page = (COQ / "README.md").read_text()
        for paper, each in counts.items():
            line = f"| `{paper}` | {sum(each)} | {len(each)} |"
            if line not in page:
                sys.exit(f"proofs/coq/README.md does not say: {line}")
            print(f"{paper}: {sum(each)} theorems in {len(each)} files, closed under the global context")

        def rejected(case: tuple[str, str, Path]) -> str | None:
            what, text, file = case
            target = copy / "mutants" / f"m{abs(hash((what, str(file))))}.v"
            target.write_text(text)
            done = coqc(copy, target)
            # The computation comes out otherwise; a file that cannot be read says nothing.
            honest = '"true = true" while it is expected' in " ".join(done.stderr.split())
            if done.returncode and honest:
                return None
            return f"{file.relative_to(COQ)}, {what}: {done.stderr or 'accepted'}"

        (copy / "mutants").mkdir()
        mutants = [
            (what, text, file) for file in papers if len(file.read_text()) < 20_000 for what, text in changed(file.read_text())
        ]
        wrong = [said for said in pool.map(rejected, mutants) if said]
        for said in wrong:
            print(said, file=sys.stderr)
        print(f"mutations: {len(mutants)}, of which {len(mutants) - len(wrong)} are rejected")
        print(f"{time.monotonic() - started:.0f} s")
        if len(mutants) < LEAST_MUTATIONS:
            sys.exit(f"{LEAST_MUTATIONS} mutations are the least")
    return 1 if wrong else 0


def compile_one(copy: Path, target: Path, text: str, over_reals: bool) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text)
    done = coqc(copy, target)
    if done.returncode:
        sys.exit(f"{target.relative_to(copy)}: coqc fails\n{done.stdout}{done.stderr}")
    asked = text.count("\nPrint Assumptions ")
    axioms = assumptions(done.stdout)
    closed = done.stdout.count("Closed under the global context")
    if over_reals:
        if axioms - ALLOWED:
            sys.exit(f"{target.relative_to(copy)}: axioms that are not allowed: {', '.join(axioms - ALLOWED)}")
    elif closed != asked or axioms:
        sys.exit(f"{target.relative_to(copy)}: {asked - closed} theorems are not closed: {', '.join(axioms)}")


if __name__ == "__main__":
    sys.exit(main())
