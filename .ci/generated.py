#!/usr/bin/env python3
"""Regenerates what the program writes into the repository, or checks it.

In README.md and docs/*.md, a block

    <!-- run: subcert constants chaikin -->
    ```text
    ...
    ```

holds what that command writes. Before the colon, `from=WORD` begins at the first line that
begins with WORD, and `head=N` keeps N lines. A block under `<!-- file: PATH -->` holds that
file, and one under `<!-- part of: PATH -->` some lines of it. A table under
`<!-- table below=HEADING: COMMAND -->` is the first one below this heading of the command's Markdown.
The files of FILES, and proofs/errata, hold what their command writes, and nothing else; docs/audits/index.html
is the index of the pages that `audit --format html` writes, with links to the errata in place of pages, which are not
in the repository. docs/gallery.md has the audits of proofs/projects, docs/literature.md what all papers have that differs, with a link to the certificate of each line. proofs/coq/papers has the theorems of `prove --coq`, and no other file. docs/depth.svg is a picture of a page of `depth`, with the styles of the page.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(
    r"(?P<before><!-- (?P<kind>run|file|part of)(?: from=(?P<start>\S+))?(?: head=(?P<head>\d+))?:"
    r" (?P<what>[^\n]*?) -->\n```\w*\n)(?P<text>.*?)(?P<after>```\n)",
    re.DOTALL,
)
# A table of a Markdown report, below this heading of it.
TABLE = re.compile(r"(?P<before><!-- table below=(?P<heading>[^:]+): (?P<what>[^\n]*?) -->\n\n)(?P<text>(?:\|[^\n]*\n)+)")
PAGES = ["README.md", *(f"docs/{page.name}" for page in sorted((ROOT / "docs").glob("*.md")))]
FILES = {"proofs/COVERAGE.md": "coverage --format markdown", "docs/flags.md": "flags --format markdown", "docs/atlas.md": "atlas --format markdown"} | {
    f"proofs/certificates/{claims.stem}.cert": f"prove {claims.stem} -o -"
    for claims in sorted((ROOT / "proofs" / "claims").glob("*.toml"))
}
# Claims about smoothness, which are no part of the program.
KINDS = sorted((ROOT / "proofs" / "claims").glob("*/*.toml"))
for claims in KINDS:
    folder = claims.parent.name
    FILES[f"proofs/certificates/{folder}/{claims.stem}.cert"] = f"prove {claims.relative_to(ROOT)} -o -"
    FILES[f"proofs/errata/{folder}/{claims.stem}.md"] = f"errata {claims.relative_to(ROOT)}"
# Constants that public programs ship.
PROJECTS = sorted((ROOT / "proofs" / "projects").glob("*.toml"))
for claims in PROJECTS:
    FILES[f"proofs/certificates/projects/{claims.stem}.cert"] = f"prove {claims.relative_to(ROOT)} -o -"
    FILES[f"proofs/errata/projects/{claims.stem}.md"] = f"errata {claims.relative_to(ROOT)}"
GALLERY = """\
# What public programs ship

This page compares tables of constants in public source code with their exact values. Each was read at the commit that is named;
the page has facts and figures, and no code. The claim files are in [`proofs/projects`](../proofs/projects), with
[certificates](../proofs/certificates/projects) and a [text for each project](../proofs/errata/projects).
[Constants in programs](programs.md) says what the words mean. To judge all of them again:

```sh
subcert audit proofs/projects/*.toml
```

"""


def gallery() -> str:
    files = " ".join(str(claims.relative_to(ROOT)) for claims in PROJECTS)
    text = output(f"audit {files} --format markdown")
    return GALLERY + re.sub(r"^(#+ )", r"#\1", text, flags=re.MULTILINE)


# The first cell of a line of docs/literature.md.
CLAIM = re.compile(r"^\| (?P<key>[\w-]+):(?P<id>\S+) \|", re.MULTILINE)
LITERATURE = """
The tables come from the claim files in [`proofs/claims`](../proofs/claims), for papers whose text was read, and from those with
[claims about smoothness](../proofs/claims/smoothness) or [relations](../proofs/claims/relations), each with a note on what was seen of its source. Theorems,
tables and formulas were judged as printed. Each claim leads to the certificate that has it, which
`subcert-check` verifies. Of a claim that is true but not sharp, it proves what is printed; the sharper statement was shown by `subcert` alone. The [texts for each paper](../proofs/errata) have all cells. To judge all of them again:

```sh
subcert errata --together proofs/claims/*.toml proofs/claims/*/*.toml
```

[Programs](gallery.md) have a page of their own.
"""


def literature() -> str:
    claims = [*sorted((ROOT / "proofs" / "claims").glob("*.toml")), *KINDS]
    folders = {one.stem: f"{one.parent.name}/" if one in KINDS else "" for one in claims}
    text = output("errata --together " + " ".join(str(one.relative_to(ROOT)) for one in claims))

    def link(match: re.Match) -> str:
        key, name = match["key"], match["id"]
        path = f"proofs/certificates/{folders[key]}{key}.cert"
        plain = re.escape(name.replace("\\", ""))
        has = re.search(rf"^(?!end )\w+ {plain}$", (ROOT / path).read_text(), re.MULTILINE)
        return f"| [{key}:{name}](../{path}) |" if has else f"| {key}:{name}, without a certificate |"

    title, count, rest = text.split("\n\n", 2)
    return f"{title}\n\n{count}\n{LITERATURE}\n" + CLAIM.sub(link, rest)


def output(command: str) -> str:
    program = ROOT / "target" / "release" / "subcert"
    words = [word.strip("'") for word in re.findall(r"'[^']*'|\S+", command)]
    # Lines follow the width of the terminal where these are set.
    environment = {key: value for key, value in os.environ.items() if key not in ("COLUMNS", "LINES")}
    done = subprocess.run(
        [program, *words], cwd=ROOT, env=environment, capture_output=True, text=True, check=True
    )
    return "\n".join(line.rstrip() for line in done.stdout.splitlines()) + "\n"


def index() -> str:
    with tempfile.TemporaryDirectory() as folder:
        output(f"audit --format html -o {folder}")
        page = (Path(folder) / "index.html").read_text()
    says = "Each paper has a page with its tables, cell by cell."
    here = (
        "Each link leads to what is wrong in a paper. <code>subcert audit --format html -o DIR</code> writes a page for "
        "each, with its tables cell by cell, and this index with links to them."
    )
    page, links = re.subn(r'href="([\w.-]+)\.html"', r'href="../../proofs/errata/\1.md"', page)
    if says not in page or not links:
        sys.exit("the index of pages has no links to pages, or does not say what they are")
    return page.replace(says, here)


def theorems() -> dict[str, str]:
    """The theorems of Coq, by the names of their files."""
    with tempfile.TemporaryDirectory() as folder:
        output(f"prove --coq {folder}")
        files = sorted(Path(folder).rglob("*.v"))
        return {f"proofs/coq/papers/{file.relative_to(folder)}": file.read_text() for file in files}


def picture() -> str:
    """The first picture of levels of a page of `depth`, as a file of its own."""
    page = output("depth examples/my-scheme.toml --tolerance 1/1000 --format html")
    drawings = re.findall(r"<svg .*?</svg>", page, re.DOTALL)
    drawing = next(one for one in drawings if "<title>Against the level</title>" in one)
    style = re.search(r"<style>(.*?)</style>", page, re.DOTALL)[1]
    used = [line for line in style.splitlines() if line.startswith((":root", "--", "@media screen and (prefers", "svg"))]
    ground = '<rect width="100%" height="100%" style="fill:var(--paper)"/>'
    head, rest = drawing.split(">", 1)
    words, rest = rest.split("</desc>", 1)
    head = head.replace("<svg ", '<svg xmlns="http://www.w3.org/2000/svg" ')
    return f"{head}>{words}</desc><style>\n" + "\n".join(used) + f"\n</style>{ground}{rest}\n"


def excerpt(text: str, start: str | None, head: str | None) -> str:
    lines = text.splitlines()
    if start:
        lines = lines[next(i for i, line in enumerate(lines) if line.startswith(start)) :]
    if head and len(lines) > int(head):
        lines = [*lines[: int(head)], "…"]
    return "\n".join(lines) + "\n"


def block(match: re.Match) -> str:
    what, text = match["what"], match["text"]
    if match["kind"] == "run":
        text = excerpt(output(what.removeprefix("subcert ")), match["start"], match["head"])
    elif match["kind"] == "file":
        text = (ROOT / what).read_text()
    elif text not in (ROOT / what).read_text():
        sys.exit(f"{what} does not contain these lines of a page:\n{text}")
    return match["before"] + text + match["after"]


def table(match: re.Match) -> str:
    lines = output(match["what"].removeprefix("subcert ")).splitlines()
    below = lines[lines.index(f"## {match['heading']}") :]
    start = next(i for i, line in enumerate(below) if line.startswith("|"))
    end = next(i for i in range(start, len(below)) if not below[i].startswith("|"))
    return match["before"] + "\n".join(below[start:end]) + "\n"


def main() -> int:
    generated = {page: TABLE.sub(table, BLOCK.sub(block, (ROOT / page).read_text())) for page in PAGES}
    generated |= {name: output(command) for name, command in FILES.items()}
    generated["docs/audits/index.html"] = index()
    generated["docs/depth.svg"] = picture()
    generated["docs/gallery.md"] = gallery()
    generated["docs/literature.md"] = literature()
    for claims in sorted((ROOT / "proofs" / "claims").glob("*.toml")):
        key = claims.stem
        generated[f"proofs/errata/{key}.md"] = output(f"errata --paper {key}")
    written = theorems()
    generated |= written
    there = {str(file.relative_to(ROOT)) for file in (ROOT / "proofs" / "coq" / "papers").rglob("*.v")}
    idle = sorted(there - written.keys())
    if "--check" not in sys.argv[1:]:
        for name in idle:
            (ROOT / name).unlink()
        for name, text in generated.items():
            (ROOT / name).parent.mkdir(parents=True, exist_ok=True)
            (ROOT / name).write_text(text)
        return 0
    stale = [
        name
        for name, text in generated.items()
        if not (ROOT / name).exists() or (ROOT / name).read_text() != text
    ]
    for name in stale:
        print(f"{name} is not what the program writes; run .ci/generated.py", file=sys.stderr)
    for name in idle:
        print(f"{name} is no file that the program writes; run .ci/generated.py", file=sys.stderr)
    stale += idle
    if not stale:
        print(f"{', '.join(generated)}: as the program writes them")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
