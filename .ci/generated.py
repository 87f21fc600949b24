#!/usr/bin/env python3
"""Regenerates what the program writes into the repository, or checks it.

In README.md, a block

    <!-- run: subcert constants chaikin -->
    ```text
    ...
    ```

holds what that command writes; `head=N` before the command keeps N lines. The files
of FILES, and proofs/errata, hold what their command writes, and nothing else.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BLOCK = re.compile(
    r"(<!-- run(?: head=(?P<head>\d+))?: subcert (?P<command>[^\n]*?) -->\n```\w*\n)(?P<text>.*?)(```\n)",
    re.DOTALL,
)
FILES = {"proofs/COVERAGE.md": "coverage --format markdown"} | {
    f"proofs/certificates/{claims.stem}.cert": f"prove {claims.stem} -o -"
    for claims in sorted((ROOT / "proofs" / "claims").glob("*.toml"))
}


def output(command: str, head: str | None = None) -> str:
    program = ROOT / "target" / "release" / "subcert"
    words = [word.strip("'") for word in re.findall(r"'[^']*'|\S+", command)]
    # A width that the shell exports would lay the tables out otherwise.
    env = {name: value for name, value in os.environ.items() if name not in ("COLUMNS", "LINES")}
    done = subprocess.run(
        [program, *words], cwd=ROOT, capture_output=True, text=True, check=True, env=env
    )
    lines = done.stdout.splitlines()
    if head and len(lines) > int(head):
        lines = lines[: int(head)] + ["…"]
    return "\n".join(line.rstrip() for line in lines) + "\n"


def with_blocks(text: str) -> str:
    return BLOCK.sub(
        lambda match: match[1] + output(match["command"], match["head"]) + match[5], text
    )


def main() -> int:
    generated = {"README.md": with_blocks((ROOT / "README.md").read_text())}
    generated |= {name: output(command) for name, command in FILES.items()}
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
