#!/usr/bin/env python3
"""schema.py PROGRAM SOURCES

What PROGRAM writes with --json is what docs/signorini.schema.json in SOURCES says: documents of every kind are valid, each member that
the schema names is in one of them, and a document with a damage is refused. Without the module jsonschema (tools/setup.sh formats)
nothing is asked and the status is 77.
"""
import copy
import json
import os
import subprocess
import sys

try:
    import jsonschema
except ImportError:
    print("schema.py: not found: jsonschema")
    sys.exit(77)

program, sources = sys.argv[1:]
ELSEWHERE = {"processes"}  # of back ends that work on several processes
RUNS = [["plan", "examples/hertz.toml"], ["solve", "examples/cantilever.toml", "--accuracy", "1%"],
        ["lcp", "tests/data/siconos_lcp/lcp_CPS_1.dat", "--solver", "all"], ["qp", "tests/data/maros_meszaros/HS52.txt", "--solver", "all"],
        ["friction", "tests/data/siconos_fc2d/FC2D_SliderCrankLagrangian00000.dat", "--solver", "all"],
        ["friction", "tests/hard/friction/three_answers.txt"], ["solve", "examples/bolt_in_tube.toml"], ["solve", "examples/probes.toml"], ["solve", "src/addons/effects/springs.toml"],
        ["solve", "src/addons/equations/equations.toml"],
        ["mesh", "examples/lining.toml"], ["mesh", "tests/data/inp/two_blocks.inp"], ["mesh", "tests/data/inp/layers.toml"],
        ["mesh", "tests/data/inp/inverted.inp"]]
RUNS += [["solve", "tests/data/transcripts/%s.toml" % name]
         for name in ("effects", "flat", "lifted", "path", "rough", "sliding", "sphere", "statics", "there_and_back")]
RUNS += [["solve", "tests/data/transcripts/flat.toml", "--accuracy", "5%", "--goal", "peak"]]


def written(run):
    said = subprocess.run([program, *run, "--json"], cwd=sources, capture_output=True, text=True)
    if said.stderr or said.returncode > 1:
        sys.exit("schema.py: %s: status %d: %s" % (" ".join(run), said.returncode, said.stderr))
    return json.loads(said.stdout)


def members(schema):
    """The names that a schema, or a part of it, gives to members."""
    if isinstance(schema, list):
        return set().union(*map(members, schema)) if schema else set()
    if not isinstance(schema, dict):
        return set()
    own = {name for name, part in schema.get("properties", {}).items() if part is not False}
    return own.union(*(members(part) for key, part in schema.items() if key != "const"))


def named(document):
    """The names of the members of a document."""
    if isinstance(document, list):
        return set().union(*map(named, document)) if document else set()
    return set(document).union(*map(named, document.values())) if isinstance(document, dict) else set()


def damaged(document):
    """Documents that are not valid, with what was done to them."""
    for name in [key for key in document if key != "limit"]:
        yield "without " + name, {key: value for key, value in document.items() if key != name}
    for name in document:
        yield "a number more in " + name, {**document, name: [document[name], 1]}
    yield "another format", {**document, "format": "signorina"}
    yield "another version", {**document, "version": 3}
    yield "an unknown member", {**document, "magic": 1}
    within = {"plan": lambda d: d["plan"]["predicted"][0], "solution": lambda d: d.get("pairs", d["certificate"]),
              "steps": lambda d: d["steps"][0], "accuracy": lambda d: d["accuracy"]["rounds"][0],
              "mesh": lambda d: d["bodies"][0]}
    deep = copy.deepcopy(document)
    within.get(document["kind"], lambda d: d["problems"][0]["solvers"][0])(deep)["magic"] = 1
    yield "an unknown member within", deep


def main():
    with open(os.path.join(sources, "docs/signorini.schema.json"), encoding="utf-8") as text:
        schema = json.load(text)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split()[1]
    seen, kinds, refused = set(), set(), 0
    for run in RUNS:
        document = written(run)
        error = jsonschema.exceptions.best_match(validator.iter_errors(document))
        if error:
            return "schema.py: %s: %s: %s" % (" ".join(run), error.json_path, error.message[:300])
        if document["program"] != version:
            return "schema.py: %s: written by %s, but the program is %s" % (" ".join(run), document["program"], version)
        if document["kind"] not in kinds:
            for what, wrong in damaged(document):
                if validator.is_valid(wrong):
                    return "schema.py: %s: taken for valid: %s" % (" ".join(run), what)
                refused += 1
        seen |= named(document)
        kinds.add(document["kind"])
    missing = members(schema) - seen - ELSEWHERE
    if missing:
        return "schema.py: the schema has members that no document has: %s" % ", ".join(sorted(missing))
    if kinds != set(schema["properties"]["kind"]["enum"]):
        return "schema.py: only these kinds were written: %s" % ", ".join(sorted(kinds))
    print("%d documents of %d kinds are valid, %d with a damage are not" % (len(RUNS), len(kinds), refused))
    return 0


sys.exit(main())
