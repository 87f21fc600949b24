#!/usr/bin/env python3
"""Writes web/index.html: web/page.html with its styles, scripts and programs inside, so that it opens from a folder, where browsers load no modules.

Modules become functions, one after the other, each behind those that it imports.
"""

import base64
import gzip
import re
import sys
from pathlib import Path

WEB = Path(__file__).resolve().parent.parent / "web"
IMPORT = re.compile(r'^import (?:(?P<default>\w+)|\{(?P<names>[^}]*)\}) from "\./(?P<file>[\w.-]+)";\n', re.MULTILINE)
EXPORT = re.compile(r"^export (?:async )?(?:const|let|class|function\*?) (\w+)", re.MULTILINE)
PROGRAMS = ["subcert", "subcert-rest", "subcert-check"]


def bundle(entry: str) -> str:
    order: list[str] = []
    parts = []

    def own(file: str) -> str:
        return "of_" + re.sub(r"\W", "_", file)

    def visit(file: str) -> None:
        if file in order:
            return
        text = (WEB / file).read_text()
        for found in IMPORT.finditer(text):
            visit(found["file"])
        order.append(file)
        taken = lambda found: (
            f"const {found['default']} = {own(found['file'])}.default;\n" if found["default"] else f"const {{{found['names'].replace(' as ', ': ')}}} = {own(found['file'])};\n"
        )
        given = [*EXPORT.findall(text), *(["default: given"] if "\nexport default " in text else [])]
        text = IMPORT.sub(taken, text).replace("\nexport default ", "\nconst given = ")
        text = re.sub(r"^export ", "", text, flags=re.MULTILINE)
        if re.search(r"^import |^\{", text, re.MULTILINE):
            sys.exit(f"web/{file}: an import or export that is not on a line of its own")
        parts.append(f"// {file}\nconst {own(file)} = (() => {{\n{text}\nreturn {{ {', '.join(given)} }};\n}})();\n")

    visit(entry)
    script = "\n".join(parts)
    if "</script" in script or "<!--" in script:
        sys.exit("a script holds the end of one")
    return script


def main() -> None:
    page = (WEB / "page.html").read_text()
    page = re.sub(r'<link rel="stylesheet" href="\./([\w.-]+)">', lambda found: f"<style>\n{(WEB / found[1]).read_text()}</style>", page)
    inside = ""
    # The program is in two parts where it could be divided.
    for program in (name for name in PROGRAMS if name != "subcert-rest" or (WEB / "subcert-rest.wasm").exists()):
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
