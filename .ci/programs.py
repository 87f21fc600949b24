#!/usr/bin/env python3
"""Random constants of programs: subcert and its checker against gcc, node and Python, bit by bit.

    .ci/programs.py [--seed SEED] [PROGRAM CHECKER]

Draws expressions of literals. The compiler or interpreter says what each of them is as a double, and which have no
value: an integer that overflows in C, a division of integers by zero. subcert has to hold the same number, its
checker has to accept the certificate of that, and what has no value has to be refused. Without node its part is
skipped with a line that says so.
"""

import argparse
import math
import random
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
COUNT = 400
REFUSED = 25
HEAD = """key = "programs"
[project]
name = "Random expressions"
repository = "https://example.org/programs"
commit = "0123456789012345678901234567890123456789"
licence = "MIT"
"""


def integer(draw, language):
    size = draw.choice([10, 1000, 2**31, 2**32, 2**33, 2**53, 2**63])
    value = draw.choice([draw.randrange(size), max(size - draw.randrange(3), 0)])
    if language != "c":
        return draw.choice([str(value * draw.choice([1, 1, 10**20])), hex(value)])
    suffix = draw.choice(["", "", "", "u", "L", "UL", "ll", "ull"])
    return draw.choice([str(value), hex(value)]) + suffix


def decimal(draw, language):
    text = f"{draw.randrange(1000)}.{draw.randrange(10**draw.choice([1, 3, 20]))}{draw.choice(['', '', 'e-3', 'e5'])}"
    return text + (draw.choice(["", "f"]) if language == "c" else "")


def expression(draw, language, depth):
    kind = draw.randrange(10)
    if depth == 0 or kind == 0:
        return integer(draw, language) if draw.randrange(4) else decimal(draw, language)
    inner = expression(draw, language, depth - 1)
    if kind == 1:
        return f"-({inner})"
    if kind == 2 and language == "c":
        return f"({draw.choice(['float', 'double'])})({inner})"
    if kind == 2 and language == "python":
        return f"float({inner})"
    return f"({inner}) {draw.choice('+-*/')} ({expression(draw, language, depth - 1)})"


def by_gcc(texts, folder):
    """The values; the text of a reason where there is none."""
    source = folder / "values.c"
    source.write_text("\n".join(f"double f{i}(void) {{ return {text}; }}" for i, text in enumerate(texts)) + "\n")
    command = ["gcc", "-fsyntax-only", "-fmax-errors=0", "-Wall", "-Wextra", str(source)]
    said = subprocess.run(command, capture_output=True, text=True).stderr
    values = {}
    for line, why in re.findall(r"values\.c:(\d+):\d+: (?:warning|error): (.*)", said):
        if "integer overflow" in why or "too large" in why or "is so large" in why:
            values[int(line) - 1] = why

    # gcc warns of a division by zero for `1.0 / 0` too, which is infinite: only a quotient of integers raises the
    # signal. As below for JavaScript, what is infinite on the way is left out.
    head = """#include <math.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
static int infinite;
static sigjmp_buf next;
#define finite(x) ({ __typeof__(x) value = (x); infinite |= isinf((double)value); value; })
#define print(at, x) infinite = 0; \\
    if (sigsetjmp(next, 1)) puts(#at " division by zero"); \\
    else { double value = (x); printf("%d %a\\n", at, infinite ? INFINITY : value); }
static void raised(int signal) { siglongjmp(next, signal); }
int main(void) {
signal(SIGFPE, raised);
"""
    guarded = [re.sub(r"\((?!float\)|double\))", "finite(", text) for text in texts]
    lines = [f"print({i}, {text})" for i, text in enumerate(guarded) if i not in values]
    source.write_text(head + "\n".join(lines) + "\nreturn 0;}\n")
    program = folder / "values"
    subprocess.run(["gcc", "-w", "-O0", "-o", str(program), str(source)], check=True)
    said = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout
    for line in said.splitlines():
        place, value = line.split(maxsplit=1)
        values[int(place)] = value if value == "division by zero" else float.fromhex(value)
    return [values[i] for i in range(len(texts))]


def by_node(texts, _folder):
    # What an infinity gives in the end is `incomplete` to the checker: such expressions are left out.
    script = "const b = new DataView(new ArrayBuffer(8));\nconst finite = x => { if (isFinite(x)) return x; throw x; };\n"
    for text in texts:
        text = text.replace("(", "finite(")
        script += f"try {{ b.setFloat64(0, {text}); }} catch {{ b.setFloat64(0, NaN); }}\n"
        script += "console.log(b.getBigUint64(0).toString());\n"
    said = subprocess.run(["node", "-"], input=script, check=True, capture_output=True, text=True).stdout
    return [struct.unpack("d", struct.pack("Q", int(line)))[0] for line in said.split()]


def by_python(texts, _folder):
    def value(text):
        try:
            return float(eval(text))
        except ZeroDivisionError as error:
            # Of floats, subcert says that the number is not finite.
            return str(error) if str(error) == "division by zero" and "." not in text and "float" not in text else math.inf
        except OverflowError:
            return math.inf

    return [value(text) for text in texts]


def claim(folder, ending, cells, values):
    marks = {"c": ("double table[] = {", "};"), "js": ("const table = [", "];"), "py": ("table = [", "]")}
    begin, end = marks[ending]
    (folder / f"source.{ending}").write_text(begin + "\n" + ",\n".join(cells) + end + "\n")
    exact = ", ".join('"{}/{}"'.format(*value.as_integer_ratio()) for value in values)
    claims = folder / "programs.toml"
    claims.write_text(
        f'{HEAD}[[shipped]]\nid = "all"\nlocus = "source.{ending}"\ntitle = "all"\ntype = "f64"\n'
        f'indices = ["k = 1..{len(cells)}"]\nequals_cells = [{exact}]\n'
        f'cells_from = {{ file = "source.{ending}", after = "table" }}\n'
    )
    return claims


def compare(language, ending, values_by, draw, program, checker):
    texts = [expression(draw, language, 3) for _ in range(COUNT)]
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        values = list(zip(texts, values_by(texts, folder)))
        finite = [(text, value) for text, value in values if isinstance(value, float) and math.isfinite(value)]
        cells, numbers = zip(*finite)
        claims = claim(folder, ending, cells, numbers)
        written = subprocess.run([program, "prove", str(claims), "-o", "-"], capture_output=True, text=True)
        if written.returncode:
            sys.exit(f"{language}: subcert refuses what has a value\n{written.stderr}")
        verdicts = re.findall(r'^  cell \d+ "(.*)" (.*)$', written.stdout, re.M)
        wrong += [f"{text} is {value!r}: {verdict}" for (text, verdict), value in zip(verdicts, numbers) if verdict != "nearest"]
        if len(verdicts) != len(cells):
            wrong.append(f"{len(verdicts)} verdicts for {len(cells)} numbers")
        certificate = folder / "programs.cert"
        certificate.write_text(written.stdout)
        checked = subprocess.run([checker, str(claims), str(certificate)], capture_output=True, text=True)
        if checked.returncode:
            wrong.append(checked.stdout + checked.stderr)
        undefined = [(text, why) for text, why in values if isinstance(why, str)]
        for text, why in undefined[:REFUSED]:
            tried = subprocess.run([program, "audit", str(claim(folder, ending, [text], [1.0]))], capture_output=True)
            if tried.returncode != 2:
                wrong.append(f"{text} is not refused: {why}")
    for line in wrong:
        print(line)
    print(f"{language}: {len(finite)} numbers compared, {min(len(undefined), REFUSED)} without a value, {len(wrong)} wrong")
    return bool(wrong)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(2**32))
    parser.add_argument("programs", nargs="*")
    options = parser.parse_args()
    default = [ROOT / "target/release/subcert", ROOT / "target/release/subcert-check"]
    program, checker = options.programs or map(str, default)
    print(f"seed {options.seed}")
    draw = random.Random(options.seed)
    failed = compare("c", "c", by_gcc, draw, program, checker)
    failed |= compare("python", "py", by_python, draw, program, checker)
    if shutil.which("node"):
        failed |= compare("javascript", "js", by_node, draw, program, checker)
    else:
        print("javascript: skipped, as there is no node")
    sys.exit(failed)


if __name__ == "__main__":
    main()
