#!/usr/bin/env python3
"""Regenerates what the program writes into the repository, or checks it.

In README.md and docs/*.md, a block

    <!-- run: subcert constants chaikin -->
    ```text
    ...
    ```

holds what that command writes. Before the colon, `from=WORD` begins at the first line that
begins with WORD, and `head=N` keeps N lines. A block under `<!-- file: PATH -->` holds that
file, and one under `<!-- part of: PATH -->` some lines of it.
The files of FILES, and proofs/errata, hold what their command writes, and nothing else; docs/audits/index.html
is the index of the pages that `audit --format html` writes.
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
PAGES = ["README.md", *(f"docs/{page.name}" for page in sorted((ROOT / "docs").glob("*.md")))]
FILES = {"proofs/COVERAGE.md": "coverage --format markdown"} | {
    f"proofs/certificates/{claims.stem}.cert": f"prove {claims.stem} -o -"
    for claims in sorted((ROOT / "proofs" / "claims").glob("*.toml"))
}
# Claims about smoothness, which are no part of the program.
SMOOTHNESS = sorted((ROOT / "proofs" / "claims" / "smoothness").glob("*.toml"))
for claims in SMOOTHNESS:
    FILES[f"proofs/certificates/smoothness/{claims.stem}.cert"] = f"prove {claims.relative_to(ROOT)} -o -"
    FILES[f"proofs/errata/smoothness/{claims.stem}.md"] = f"errata {claims.relative_to(ROOT)}"


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
        return (Path(folder) / "index.html").read_text()


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


def main() -> int:
    generated = {page: BLOCK.sub(block, (ROOT / page).read_text()) for page in PAGES}
    generated |= {name: output(command) for name, command in FILES.items()}
    generated["docs/audits/index.html"] = index()
    for claims in sorted((ROOT / "proofs" / "claims").glob("*.toml")):
        key = claims.stem
        generated[f"proofs/errata/{key}.md"] = output(f"errata --paper {key}")
    if "--check" not in sys.argv[1:]:
        for name, text in generated.items():
            (ROOT / name).parent.mkdir(exist_ok=True)
            (ROOT / name).write_text(text)
        return 0
    stale = [
        name
        for name, text in generated.items()
        if not (ROOT / name).exists() or (ROOT / name).read_text() != text
    ]
    for name in stale:
        print(f"{name} is not what the program writes; run .ci/generated.py", file=sys.stderr)
    if not stale:
        print(f"{', '.join(generated)}: as the program writes them")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
