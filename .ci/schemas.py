#!/usr/bin/env python3
"""The JSON schemas of docs/schema: `--write` writes them from the types of the program; without it they are compared,
answers of every command are validated against them (with the package jsonschema), and so are all claim files. Claim
files with a field too many, too few or of another name are refused by schema and program alike."""

import json
import re
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCHEMAS = ROOT / "docs/schema"

# The file of the schema, and a command that writes such an answer.
ANSWERS = [
    ("atlas", "atlas chaikin daubechies-4 loop"),
    ("audit", "audit examples/first-paper.toml"),
    ("audit", "audit examples/my-paper.toml --all"),
    ("audit", "audit examples/first-paper.toml --certified"),
    ("audit", "audit --paper mustafa2007-ternary"),
    ("audit-project", "audit examples/weights.toml"),
    ("certify", "certify four-point:w=1/16"),
    ("constants", "constants six-point:w=3/256 -c 3"),
    ("constants", "constants four-point:w=1/16 x chaikin -c 2"),
    ("constants-lattice", "constants (1+x)*(1+y)*(1+x*y)/2 -c 2"),
    ("constants-ring", "constants doo-sabin:n=5 -c 2"),
    ("coverage", "coverage --paper khan2019-newton"),
    ("depth", "depth chaikin --tolerance 1/100"),
    ("depth", "depth chaikin --polygon examples/polygon.csv --tolerance 1/100"),
    ("depth-mesh", "depth catmull-clark --mesh examples/cube.obj --tolerance 1/10 --distance parametric"),
    ("depth-mesh-geometric", "depth doo-sabin --mesh examples/cube.obj --tolerance 1/10"),
    ("depth-lattice", "depth (1+x)*(1+y)*(1+x*y)/2 --tolerance 1/100"),
    ("depth-ring", "depth doo-sabin:n=5 --tolerance 1/100"),
    ("errata", "errata --paper khan2019-newton"),
    ("explain", "explain khan2022-doo-sabin:theorem-3"),
    ("explain-list", "explain khan2019-newton"),
    ("explain-project", "explain weights:neighbours examples/weights.toml"),
    ("flags", "flags"),
    ("jsr", "jsr examples/pair.txt"),
    ("jsr", "jsr examples/pair.txt --below 4"),
    ("oracle", "oracle chaikin"),
    ("range", "range four-point --param w -c 2"),
    ("range-best-contraction", "range four-point --param w --best contraction -c 2"),
    ("range-best-exponent", "range four-point --param w --best exponent --bounds w=0..1/8"),
    ("range-smoothness", "range four-point --param w --smoothness 1"),
    ("range-smoothness-map", "range examples/primal.toml --param a --param b --smoothness 1 --boxes 20"),
    ("range-smoothness-vertex", "range examples/loop-beta.toml --param beta --smoothness 1 --valences 3..4"),
    ("scheme", "scheme four-point:w=1/16"),
    ("scheme", "scheme (1+x)*(1+y)*(1+x*y)/2"),
    ("scheme", "scheme catmull-clark:N=5"),
    ("scheme-comparison", "scheme four-point examples/my-scheme.toml"),
    ("schemes", "schemes"),
    ("smoothness-lattice", "smoothness (1+x)*(1+y)*(1+x*y)/2"),
    ("smoothness", "smoothness four-point:w=1/16"),
    ("smoothness-vertex", "smoothness catmull-clark:N=5"),
    ("spectrum", "spectrum loop --valence 5"),
    ("spectrum-sector", "spectrum catmull-clark --sector 3"),
]


def main():
    build = ["cargo", "build", "--locked", "--quiet", "--bin", "subcert", "--features", "schema"]
    # What is compiled once more for the schemas need not be quick.
    for crate in ("geometry", "claims", "check"):
        build += ["--config", f"profile.dev.package.subcert-{crate}.opt-level=0"]
    subprocess.run(build, cwd=ROOT, check=True)
    program = Path(target()) / "debug/subcert"
    if sys.argv[1:] == ["--write"]:
        subprocess.run([program, "schemas", SCHEMAS], check=True)
        return
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "schemas", folder], check=True)
        written = {path.name: path.read_text() for path in Path(folder).glob("*.json")}
    kept = {path.name: path.read_text() for path in SCHEMAS.glob("*.json")}
    differing = sorted(name for name in written.keys() | kept.keys() if written.get(name) != kept.get(name))
    if differing:
        sys.exit(f"not the schemas of the program: {', '.join(differing)}; `python3 .ci/schemas.py --write` writes them")

    from jsonschema import Draft202012Validator

    # The other two are those of claim files.
    if without := kept.keys() - {f"{name}.json" for name, _ in ANSWERS} - {"claims.json", "claims-project.json"}:
        sys.exit(f"ANSWERS has no command for {', '.join(sorted(without))}")
    for name, command in ANSWERS:
        schema = json.loads(kept[f"{name}.json"])
        Draft202012Validator.check_schema(schema)
        words = command.split(" --format")[0].split(" ")
        # A tensor product is one word.
        if " x " in command:
            start = words.index("x") - 1
            words[start : start + 3] = [" ".join(words[start : start + 3])]
        said = subprocess.run([program, *words, "--format", "json"], cwd=ROOT, capture_output=True, text=True)
        if said.returncode != 0:
            sys.exit(f"subcert {command}: {said.stderr}")
        for error in Draft202012Validator(schema).iter_errors(json.loads(said.stdout)):
            sys.exit(f"subcert {command} --format json: {error.json_path}: {error.message[:300]}")
        # A schema that allows everything would say nothing.
        if not list(Draft202012Validator(schema).iter_errors({"schema": "one"})):
            sys.exit(f"{name}.json allows an answer of no form")
    files, spoiled = claim_files(program, kept)
    print(f"{len(kept)} schemas are those of the program, and {len(ANSWERS)} answers fit them")
    print(f"{files} claim files fit them; of {spoiled} spoiled ones schema and program say the same")


def claim_files(program, kept):
    """How many claim files there are, and how many have been spoiled."""
    from jsonschema import Draft202012Validator

    schemas = {name: Draft202012Validator(json.loads(kept[f"{name}.json"])) for name in ("claims", "claims-project")}
    for schema in schemas.values():
        Draft202012Validator.check_schema(schema.schema)

    def refused(text):
        parsed = tomllib.loads(text)
        name = "claims-project" if "project" in parsed else "claims"
        return next((f"{e.json_path}: {e.message[:200]}" for e in schemas[name].iter_errors(parsed)), None)

    files, spoiled, met = 0, 0, set()
    places = [ROOT / "proofs/claims", ROOT / "examples"]
    for file in sorted(path for place in places for path in place.rglob("*.toml")):
        text = file.read_text()
        # Other files of examples are schemes.
        if not re.search(r"^\[(paper|project)\]", text, re.MULTILINE):
            continue
        files += 1
        if error := refused(text):
            sys.exit(f"{file}: {error}")
        for number, other in enumerate(spoil(text, met)):
            try:
                wrong = refused(other)
            except tomllib.TOMLDecodeError:
                continue
            spoiled += 1
            with tempfile.NamedTemporaryFile("w", suffix=".toml") as copy:
                copy.write(other)
                copy.flush()
                # The file is read, and of no such claim nothing is computed.
                command = [program, "explain", "none:none", copy.name]
                said = subprocess.run(command, capture_output=True, text=True).stderr
            form = re.search("unknown field|missing field|invalid (type|value)", said)
            if bool(form) != bool(wrong):
                sys.exit(f"{file}, spoiled {number}: the schema says {wrong}, and the program {said or 'nothing'}")
    return files, spoiled


def spoil(text, met):
    """The file with one field too many, with one of another name, with one of another type, and with one too few:
    once for each kind of table and each field, of which `met` has those of other files."""
    headers, fields = {}, {}
    kind = ""
    for number, line in enumerate(lines := text.splitlines()):
        if header := re.match(r"\[\[?([a-z_.]+)\]", line):
            kind = header[1]
            if kind not in met:
                headers[kind] = number
                met.add(kind)
        elif field := re.match(r"(\w+) = ['\"].*['\"]$", line):
            if (kind, field[1]) not in met:
                fields[kind, field[1]] = number
                met.add((kind, field[1]))
    for number in headers.values():
        yield "\n".join([*lines[: number + 1], "nonsense = '1'", *lines[number + 1 :]])
    for (_, name), number in fields.items():
        before, after = lines[:number], lines[number + 1 :]
        yield "\n".join([*before, *after])
        yield "\n".join([*before, lines[number].replace(name, f"{name}s", 1), *after])
        yield "\n".join([*before, f"{name} = true", *after])
        yield "\n".join([*before, f"{name} = 7", *after])
        yield "\n".join([*before, f"{name} = 0.5", *after])


def target():
    metadata = subprocess.run(
        ["cargo", "metadata", "--format-version", "1", "--no-deps"], cwd=ROOT, check=True, capture_output=True
    )
    return json.loads(metadata.stdout)["target_directory"]


main()
