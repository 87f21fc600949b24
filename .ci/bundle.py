#!/usr/bin/env python3
"""Writes web/index.html: web/page.html with its styles, scripts and programs inside, so that it opens from a folder, where browsers load no modules.

Modules are put one after the other, each behind those that it imports; `export default` becomes a constant of the name under which main.js
imports it. A name that two modules have at their top level stops this.
"""

import base64
import gzip
import re
import sys
from pathlib import Path

WEB = Path(__file__).resolve().parent.parent / "web"
IMPORT = re.compile(r'^import (?:(?P<default>\w+)|\{(?P<names>[^}]*)\}) from "\./(?P<file>[\w.-]+)";\n', re.MULTILINE)
NAME = re.compile(r"^(?:export )?(?:async )?(?:const|let|class|function\*?) (?:\{ ([^}]*) \}|\[([^\]]*)\]|(\w+))", re.MULTILINE)
PROGRAMS = ["subcert", "subcert-check"]


def bundle(entry: str) -> str:
    order: list[str] = []
    named: dict[str, str] = {}

    def visit(file: str) -> None:
        if file in order:
            return
        for found in IMPORT.finditer((WEB / file).read_text()):
            visit(found["file"])
            if found["default"]:
                named[found["file"]] = found["default"]
        order.append(file)

    visit(entry)
    owner: dict[str, str] = {}
    parts = []
    for file in order:
        text = IMPORT.sub("", (WEB / file).read_text())
        text = text.replace("export default ", f"const {named.get(file)} = ")
        text = re.sub(r"^export ", "", text, flags=re.MULTILINE)
        if re.search(r"^import ", text, re.MULTILINE):
            sys.exit(f"web/{file}: an import that is not on a line of its own")
        for found in NAME.finditer(text):
            for name in re.split(r",\s*", next(filter(None, found.groups()))):
                name = name.split(":")[-1].strip()
                if owner.setdefault(name, file) != file:
                    sys.exit(f"`{name}` is a name of web/{file} and of web/{owner[name]}")
        parts.append(f"// {file}\n{text}")
    script = "\n".join(parts)
    if "</script" in script:
        sys.exit("a script holds the end of one")
    return script


def main() -> None:
    page = (WEB / "page.html").read_text()
    page = re.sub(r'<link rel="stylesheet" href="\./([\w.-]+)">', lambda found: f"<style>\n{(WEB / found[1]).read_text()}</style>", page)
    inside = ""
    for program in PROGRAMS:
        packed = base64.b64encode(gzip.compress((WEB / f"{program}.wasm").read_bytes(), 9, mtime=0)).decode()
        inside += f'<script type="text/plain" id="{program}.wasm">{packed}</script>\n'
    inside += f'<script type="text/plain" id="worker.js">\n{bundle("worker.js")}</script>\n'
    inside += f'<script type="module">\n{bundle("main.js")}</script>\n'
    page = page.replace('<script type="module" src="./main.js"></script>\n', "")
    head, tail = page.rsplit("</body>", 1)
    (WEB / "index.html").write_text(f"{head}{inside}</body>{tail}")
    print(f"web/index.html has {(WEB / 'index.html').stat().st_size:,} bytes")


if __name__ == "__main__":
    main()
