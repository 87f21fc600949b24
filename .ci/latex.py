#!/usr/bin/env python3
"""Compiles the errata of the papers, as `errata --format latex` writes them, and their corrected tables, as
`explain KEY:ID --format latex` does, and answers about schemes, with pdflatex.

    .ci/latex.py [PROGRAM]

PROGRAM is target/release/subcert without it. TeX comes from Debian where it is missing.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def missing(package: str) -> bool:
    return subprocess.run(["kpsewhich", package], capture_output=True).returncode != 0


def install() -> None:
    sudo = [] if os.geteuid() == 0 else ["sudo"]
    subprocess.run([*sudo, "apt-get", "update", "-qq"], check=True)
    packages = ["texlive-latex-base", "texlive-latex-recommended", "texlive-fonts-recommended"]
    subprocess.run([*sudo, "apt-get", "install", "-y", "-qq", "--no-install-recommends", *packages], check=True)


TABLES = 3

HEAD = "\\documentclass{article}\n\\usepackage{amssymb,booktabs}\n\\begin{document}\n"


def tables(program: str, folder: str) -> None:
    """A document for each paper with the first of its corrected tables: each takes a search of some seconds."""

    def output(*arguments: str) -> str:
        return subprocess.run(
            [program, *arguments], cwd=ROOT, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
        ).stdout

    for claims in sorted((ROOT / "proofs" / "claims").glob("*.toml")):
        listed = json.loads(output("explain", claims.stem, "--format", "json"))["claims"]
        ids = [f"{claims.stem}:{claim['id']}" for claim in listed if claim["kind"] == "table"]
        texts = [output("explain", one, "--format", "latex") for one in ids[:TABLES]]
        if texts:
            document = HEAD + "\n\\clearpage\n".join(texts) + "\\end{document}\n"
            (Path(folder) / f"{claims.stem}-tables.tex").write_text(document)


ANSWERS = [
    ["smoothness", "four-point"],
    ["smoothness", "loop", "--valences", "3..6"],
    ["range", "six-point", "w"],
    ["range", "four-point", "w", "--smoothness", "1"],
    ["scheme", "[⅛, ½, ¾, ½, ⅛]", "four-point:w=1/20"],
    ["scheme", "[1 + √3, 3 + √3, 3 - √3, 1 - √3]/4"],
    ["scheme", "catmull-clark"],
    ["constants", "chaikin x four-point"],
    ["spectrum", "catmull-clark", "--valence", "5"],
    ["depth", "chaikin", "--tolerance", "1/100"],
    ["jsr", "examples/pair.txt"],
    ["certify", "chaikin"],
]


def answers(program: str, folder: str) -> None:
    """One document with the answers about schemes."""
    command = [[program, *words, "--format", "latex"] for words in ANSWERS]
    texts = [subprocess.run(one, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout for one in command]
    (Path(folder) / "answers.tex").write_text(HEAD + "\n\\clearpage\n".join(texts) + "\\end{document}\n")


def main() -> int:
    program = sys.argv[1] if len(sys.argv) > 1 else "target/release/subcert"
    if not shutil.which("pdflatex") or not shutil.which("kpsewhich") or missing("booktabs.sty"):
        install()
    wrong = False
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "--quiet", "errata", "--format", "latex", "-o", folder], cwd=ROOT, check=True)
        tables(program, folder)
        answers(program, folder)
        papers = sorted(Path(folder).glob("*.tex"))
        for paper in papers:
            command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", paper.name]
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")
            if done.returncode:
                wrong = True
                errors = [line for line in done.stdout.splitlines() if line.startswith(("!", "l."))]
                print(f"{paper.name}: {' '.join(errors)}", file=sys.stderr)
    if not papers or wrong:
        return 1
    print(f"{len(papers)} documents of errata, corrected tables and answers compile")
    return 0


if __name__ == "__main__":
    sys.exit(main())
