#!/usr/bin/env python3
"""Regenerates the program's output that README.md quotes, or checks it.

In README.md, a block

    <!-- run: subcert constants chaikin -->
    ```text
    ...
    ```

holds what that command writes; `head=N` before the command keeps N lines.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
README = ROOT / "README.md"
BLOCK = re.compile(
    r"(<!-- run(?: head=(?P<head>\d+))?: subcert (?P<command>[^\n]*?) -->\n```\w*\n)(?P<text>.*?)(```\n)",
    re.DOTALL,
)


def output(command: str, head: str | None) -> str:
    program = ROOT / "target" / "release" / "subcert"
    words = [word.strip("'") for word in re.findall(r"'[^']*'|\S+", command)]
    done = subprocess.run([program, *words], cwd=ROOT, capture_output=True, text=True, check=True)
    lines = done.stdout.splitlines()
    if head and len(lines) > int(head):
        lines = lines[: int(head)] + ["…"]
    return "\n".join(line.rstrip() for line in lines) + "\n"


def main() -> int:
    old = README.read_text()
    new = BLOCK.sub(
        lambda match: match[1] + output(match["command"], match["head"]) + match[5], old
    )
    if "--check" not in sys.argv[1:]:
        README.write_text(new)
        return 0
    if old == new:
        print(f"README.md: {len(BLOCK.findall(old))} blocks are what the program writes")
        return 0
    print("README.md quotes other output than the program writes; run .ci/generated.py", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
