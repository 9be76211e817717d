#!/usr/bin/env python3
"""inputs/scene.schema.json agrees with the reader of scenes, inputs/README.md and the scenes of the project."""
import copy
import json
import os
import re
import subprocess
import sys

from hostile_scenes import FORM, scene_with
from runner import ROOT, check, main

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}; jobs/setup.sh test installs python3-jsonschema and python3-yaml")
    sys.exit(77)

SCHEMA = json.loads((ROOT / "inputs/scene.schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)

SUPPORT = {"where": {"box": [[0, 0, 0], [1, 1, 1]]}, "velocity": [0, 0, 0]}
SHAPES = {
    "rectangle": {"corner": [0, 0, 0], "along": [1, 0, 0], "and": [0, 0, 1]},
    "disc": {"centre": [0, 0, 0], "normal": [0, 1, 0], "radius": 1},
    "polygon": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
}
NOTCHES = [{"where": {shape: value}} for shape, value in SHAPES.items()]
BY_NETWORK = {
    "block": {"cells": [1, 1, 1], "edge": 1},
    "network": {"mass": 1, "edge": {"stiffness": 1}, "diagonal": {"stiffness": 1}},
    "sensors": {"threshold": 1},
    "supports": [SUPPORT],
    "time": {"end": 1},
}
BY_MATERIAL = {
    "block": {"cells": [1, 1, 1], "edge": 1},
    "material": {"model": "standard", "young": 1, "density": 1},
    "sensors": {"threshold": 1},
    "time": {"end": 1},
}
# The values with which every key is tested, besides its default, examples and bounds, and every word of the schema.
VALUES = [None, True, False, -1, 0, 1, 2, 0.25, 1.5, -0.5, 2147483648, "", "no such word", "x", "sin(t)", [], {}, [1],
          [1, 1], [1, 1, 1], [0, 0, 0], [-1, 1, 1], [1.5, 1, 1], ["x", 0, 0], ["sin(t)", 0, 0], [None, 0, 0],
          [None, None, None], [1, 1, 1, 1], [True, 1, 1], [[1], 1, 1], [{}, 1, 1], [[0, 0, 0], [1, 1, 1]],
          [[0, 0], [1, 1, 1]], [[0, 0, 0], [1, 1, 1], [2, 2, 2]], [SUPPORT], [SUPPORT, SUPPORT], [{}],
          {"no_such_key": 1}, NOTCHES, NOTCHES[1:2], [{**notch, "name": "x"} for notch in NOTCHES],
          [{**NOTCHES[0], "no_such_key": 1}], SHAPES, *({shape: value} for shape, value in SHAPES.items()),
          *SHAPES.values(), "x" * 61, 1e-12, [0, -2, 0],
          *([[0, 0, 0], [1, 0, 0], corner, [0, 1, 0]]
            for corner in ([1, 1, 0], [1, 1, 1], [-1, 1, 0], [1, 1], [1, 1, "x"])),
          "tetrahedron", "tree", "rk4", "implicit", "static"]
MODELS = SCHEMA["properties"]["material"]["properties"]["model"]["enum"]
# Values whose spelling matters, written as in a file; every key is tested with them too.
TEXTS = ['"50"', "'1'", '"0.25"', '"1e3"', '"-1"', '"true"', '"null"', '""', ".inf", "-.inf", ".Inf", "-.INF", '".inf"',
         ".nan", "inf", "1e400", "-1e400", '"1e400"', "1e3", "4.0", "+1", "True", "FALSE", "yes", "Null", "~", "0x10",
         '"a\\tb"', '"a\\x9bb"']
# Errors of values that have the right form, which only the reader can detect. Quoted text may be an expression; .nan is
# a number that no bound excludes.
ONLY_THE_READER = ("is not a number or an expression", "may depend on x, y, z, but not on t", "must be finite",
                   "too large to be held", "infinity is written .inf", "lies so far from 0",
                   "outside of 1e-60 to 1e60", "the lower corner is above the upper one", "more than can be counted",
                   "there is a notch named", "a million times the block's reach of 1.73 m", "encloses no area",
                   "is not plane", "sides that cross or touch", "lies outside of the block", "has a radius of",
                   "needs cubes with model: paper", "a million times the shortest",
                   "a threshold is a stretch above 0 (.inf: never), not '-1'", "not '.nan'", "not '0x10'")


class Core(yaml.SafeLoader):
    """YAML 1.2's core schema, which cracksim and editors follow; PyYAML's default is YAML 1.1."""


Core.yaml_implicit_resolvers = {}
for kind, pattern, first in [
        ("bool", r"true|True|TRUE|false|False|FALSE", "tTfF"), ("null", r"null|Null|NULL|~|", ["n", "N", "~", ""]),
        ("int", r"[-+]?[0-9]+|0x[0-9a-fA-F]+", "-+0123456789"),
        ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|[-+]?\.(inf|Inf|INF)|\.nan", "-+.0123456789")]:
    Core.add_implicit_resolver(f"tag:yaml.org,2002:{kind}", re.compile(f"^(?:{pattern})$"), list(first))


def parsed(text):
    return yaml.load(text, Loader=Core)


def properties(schema, path=()):
    """Yields each property's path and schema; * stands for any item of a list."""
    for name, inner in schema.get("properties", {}).items():
        yield (*path, name), inner
        yield from properties(inner, (*path, name))
        yield from properties(inner.get("items", {}), (*path, name, "*"))


def own_values(schema):
    """Yields values near a property's own limits, and the values that it names."""
    yield from schema.get("enum", [])
    yield from schema.get("examples", [])
    for key in ("const", "default"):
        yield from [schema[key]] if key in schema else []
    if "minimum" in schema:
        yield from (schema["minimum"], schema["minimum"] * 0.99 - 1e-100)
    if "exclusiveMinimum" in schema:
        yield schema["exclusiveMinimum"]
    if "maximum" in schema:
        yield from (schema["maximum"], schema["maximum"] * 1.01)
    for item in own_values(schema["items"]) if "properties" not in schema.get("items", {"properties": 0}) else []:
        yield [item] + [1] * (schema["minItems"] - 1)


def models_of(path):
    """The models of the material with which a key is tested; None: with a network."""
    if path[0] == "material" or path == ("sensors", "kind"):
        return MODELS
    return [*MODELS, None] if path == ("block", "edge") else [None]


def scene_of(path, value, model):
    """A scene that is valid except for this value. A notch has only the surface that the path names."""
    scene = copy.deepcopy(BY_MATERIAL if model else BY_NETWORK)
    if model:
        scene["material"]["model"] = model
    place = scene
    if path[0] == "notches":
        shape = path[3] if len(path) > 3 else "disc"
        scene["notches"] = [{"where": {shape: copy.deepcopy(SHAPES[shape])} if shape in SHAPES else {}}]
    for key in path[:-1]:
        place = place[0] if key == "*" else place.setdefault(key, {})
    place[path[-1]] = value
    if path[:2] == ("sensors", "weibull") and len(path) == 3:
        place.setdefault("shape", 1)
    return scene


def answers(texts):
    """The reader's error message for each scene; empty if the scene is valid."""
    done = subprocess.run([os.environ["CRACKSIM_READ_SCENES"]], input="".join(text + "\0" for text in texts), text=True,
                          capture_output=True, check=True)
    return done.stdout.split("\n")[:-1]


def yaml_text(scene):
    return json.dumps(scene).replace("Infinity", ".inf")


def check_agreement(cases):
    """Cases are (path, description of the value, text of the scene, whether the schema accepts it)."""
    verdicts = {True: 0, False: 0}
    for (path, value, _, valid), answer in zip(cases, answers(text for _, _, text, _ in cases), strict=True):
        verdicts[valid] += 1
        verdict = f"the schema {'takes' if valid else 'refuses'} it, the reader says '{answer}'"
        what = f"{'.'.join(path)}: {value}: {verdict}"
        check(valid or answer, what)
        check(not valid or not answer or any(why in answer for why in ONLY_THE_READER), what)
    check(min(verdicts.values()) > 100, f"too few cases to tell anything: {verdicts}")


def reader_and_schema_agree(workplace, quick):
    del workplace, quick
    words = [word for _, schema in properties(SCHEMA) for word in schema.get("enum", [])]
    cases = [(path, value) for path, schema in properties(SCHEMA) for value in [*VALUES, *words, *own_values(schema)]]
    cases += [((*section, "no_such_key"), 1) for section in {path[:-1] for path, _ in properties(SCHEMA)}]
    scenes = [(path, f"{json.dumps(value)} (model: {model})", scene_of(path, value, model))
              for path, value in cases for model in models_of(path)]
    check_agreement([(path, value, yaml_text(scene), VALIDATOR.is_valid(scene)) for path, value, scene in scenes])


def reader_and_schema_read_a_spelling_alike(workplace, quick):
    del workplace, quick
    cases = []
    for path, schema in properties(SCHEMA):
        lists = [["@", 1, 1], [1, 1, "@"], [["@", 0, 0], [1, 1, 1]], [[0, 0, 0], [1, "@", 1]],
                 [["@", 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 0, 0], [1, 0, 0], [0, 1, "@"]]]
        for shape in ["@", *(lists if "array" in schema.get("type", "") else [])]:
            for model in models_of(path):
                text = yaml_text(scene_of(path, shape, model))
                cases += [(path, f"{shape} with @ = {spelling} (model: {model})", text.replace('"@"', spelling))
                          for spelling in TEXTS]
    check_agreement([(*case, VALIDATOR.is_valid(parsed(case[2]))) for case in cases])


def reader_and_schema_know_the_same_words(workplace, quick):
    del workplace, quick
    found = [(path, schema["enum"]) for path, schema in properties(SCHEMA) if "enum" in schema]
    scenes = [yaml_text(scene_of(path, "zzzzzzzzzzzz", models_of(path)[0])) for path, _ in found]
    for (path, words), answer in zip(found, answers(scenes), strict=True):
        check(re.search(rf"; take (one of )?{', '.join(words)}$", answer),
              f"{'.'.join(path)} has {words}, the reader says {answer}")
    check(found, "no words were found in the schema")


def scenes_of_the_project_are_valid(workplace, quick):
    del workplace, quick
    scenes = sorted((ROOT / "inputs").glob("*.yaml"))
    check(scenes, "inputs/ has no scenes")
    for path in scenes:
        errors = [error.message for error in VALIDATOR.iter_errors(parsed(path.read_text(encoding="utf-8")))]
        check(not errors, f"{path.name}: {errors}")


def wrong_forms_are_refused(workplace, quick):
    del workplace, quick
    for row in FORM:
        check(not VALIDATOR.is_valid(parsed(scene_with(row))), f"{row.name}: the schema takes it")
    check(len(FORM) > 20, f"only {len(FORM)} rows are a matter of form")


def readme_says_the_same(workplace, quick):
    del workplace, quick
    readme = (ROOT / "inputs/README.md").read_text(encoding="utf-8")
    rows = {}
    for line in readme.splitlines():
        cells = [cell.strip().replace("`", "") for cell in line.strip("|").split(" |")]
        if re.fullmatch(r"\| `[a-z_.*]+` \|.*\|", line) and len(cells) == 5:
            rows[cells[0]] = cells[1:]
    schemas = {".".join(path): schema for path, schema in properties(SCHEMA)}
    check(rows.keys() == schemas.keys(), f"in one of the two only: {sorted(rows.keys() ^ schemas.keys())}")
    for key, (unit, allowed, default, meaning) in rows.items():
        schema = schemas[key]
        expected = f"{meaning}." + (f" Unit: {unit}." if unit else "")
        expected += f" Range: {allowed}." if allowed not in ("", "map") else ""
        check(schema["description"] == expected, f"{key} is described as '{schema['description']}', not '{expected}'")
        if "default" in schema:
            check(parsed(default) == schema["default"], f"{key}: the defaults are {default} and {schema['default']}")


def schema_is_one(workplace, quick):
    del workplace, quick
    jsonschema.Draft7Validator.check_schema(SCHEMA)


if __name__ == "__main__":
    main([schema_is_one, reader_and_schema_agree, reader_and_schema_read_a_spelling_alike,
          reader_and_schema_know_the_same_words, scenes_of_the_project_are_valid, wrong_forms_are_refused,
          readme_says_the_same])
