"""Holds `wold schema` against `wold check`:

    schema_check.py PROGRAM

The schema is one of draft 2020-12. All examples and starter scenes are valid by it, and so is a
value at an end of each key's range. Values beyond it, of other types, unknown words, lists that are
too short or too long, unknown keys and tables are refused by the schema and by the program alike:
one fault for each key, the next kind of fault for the next key. Prints how many of each there were.
"""

import json
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import jsonschema
import tomli

HOME = Path(__file__).resolve().parents[1]
LEAST_BROKEN = 200


def load_schema(program):
    text = subprocess.run([program, "schema"], stdout=subprocess.PIPE, check=True).stdout
    schema = json.loads(text)
    jsonschema.Draft202012Validator.check_schema(schema)
    return schema


def keys_of(schema):
    """(is_array, table, key, its schema) of all keys but old names; the table is "" at the top."""
    for name, table in schema["properties"].items():
        if table.get("type") == "object":
            properties, is_array = table["properties"], False
        elif "properties" in table.get("items", {}):
            properties, is_array = table["items"]["properties"], True
        else:
            yield False, "", name, table
            continue
        for key, rule in properties.items():
            if "deprecated" not in rule:
                yield is_array, name, key, rule


def scene_with(is_array, table, key, value):
    if not table:
        return {key: value}
    return {table: [{key: value}] if is_array else {key: value}}


def broken_values(rule):
    """Values that a key of this schema does not take."""
    yield {"a": 1}
    for choice in rule.get("anyOf", [rule]):
        if "minimum" in choice:
            step = 1 if choice["type"] == "integer" else 1e-3 * max(1.0, abs(choice["maximum"]))
            yield choice["minimum"] - step
            yield choice["maximum"] + step
            yield True
        if choice.get("type") == "integer":
            yield choice["minimum"] + 0.5
        if "enum" in choice:
            yield "no such word"
        if "pattern" in choice:
            yield "a name with spaces/"
        if choice.get("type") == "array":
            yield from broken_lists(choice)
        if choice.get("type") == "string":
            yield 1


def broken_lists(rule):
    item = rule["default"][0] if rule.get("default") else None
    if rule["minItems"] > 0:
        yield []
    if item is not None and rule["maxItems"] < 100:
        yield [item] * (rule["maxItems"] + 1)
    if "minimum" in rule["items"]:
        yield [rule["items"]["minimum"] - 1] * max(1, rule["minItems"])


def broken_scenes(schema):
    tables = {}
    for number, (is_array, table, key, rule) in enumerate(keys_of(schema)):
        values = list(broken_values(rule))
        yield scene_with(is_array, table, key, values[number % len(values)])
        tables[table] = is_array
    for table, is_array in tables.items():
        yield scene_with(is_array, table, "no_such_key", 1)
    yield {"no_such_table": {"a": 1}}


def ends_of_ranges(schema):
    """Scenes whose key has the smallest or largest number that it takes, as the schema says."""
    for number, (is_array, table, key, rule) in enumerate(keys_of(schema)):
        if rule.get("type") in ("integer", "number"):
            end = ("minimum", "maximum")[number % 2]
            yield scene_with(is_array, table, key, rule[end])


def toml_value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, list):
        return "[" + ", ".join(toml_value(item) for item in value) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {toml_value(item)}" for key, item in value.items()) + "}"
    return repr(value)


def toml(scene):
    return "".join(f"{key} = {toml_value(value)}\n" for key, value in scene.items())


def check(program, scene):
    """What the program says of a scene: exit status and messages."""
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(toml(scene))
        file.flush()
        done = subprocess.run(
            [program, "check", file.name],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
    return done.returncode, done.stderr


def starter_scenes(program):
    kinds = ("hillside", "mountain", "clouds", "snow", "season")
    with tempfile.TemporaryDirectory() as folder:
        for kind in kinds:
            subprocess.run([program, "new", kind, "--kind", kind], cwd=folder, check=True)
            yield kind, (Path(folder) / f"{kind}.toml").read_text()


def valid_scenes(program):
    for path in sorted(HOME.glob("examples/**/*.toml")):
        yield path.name, path.read_text()
    yield from starter_scenes(program)


def with_answers(program, scenes):
    """Each scene with what the program says of it."""
    with ThreadPoolExecutor() as pool:
        answers = list(pool.map(lambda scene: check(program, scene), scenes))
    return zip(scenes, answers, strict=True)


def faults_of_valid(validator, scenes):
    for name, text in scenes:
        for error in validator.iter_errors(tomli.loads(text)):
            yield f"the schema refuses {name}: {error.message}"


def faults_of_broken(validator, program, scenes):
    for scene, (status, _) in with_answers(program, scenes):
        if validator.is_valid(scene):
            yield f"the schema takes {toml(scene)!r}"
        if status != 2:
            yield f"the program takes {toml(scene)!r}: exit status {status}"


def faults_of_ends(validator, program, scenes):
    for scene, (status, words) in with_answers(program, scenes):
        if not validator.is_valid(scene):
            yield f"the schema refuses {toml(scene)!r}"
        # What another key asks for may be less than the range.
        if status not in (0, 2) or re.search("expected a (whole )?number", words):
            yield f"the program refuses {toml(scene)!r}: {words}"


def main():
    program = sys.argv[1]
    schema = load_schema(program)
    validator = jsonschema.Draft202012Validator(schema)
    valid = list(valid_scenes(program))
    broken = list(broken_scenes(schema))
    ends = list(ends_of_ranges(schema))
    faults = [
        *faults_of_valid(validator, valid),
        *faults_of_broken(validator, program, broken),
        *faults_of_ends(validator, program, ends),
    ]
    print("\n".join(faults))
    print(f"{len(valid)} scenes valid, {len(broken)} broken refused, {len(ends)} ends of ranges")
    return 1 if faults or len(broken) < LEAST_BROKEN else 0


if __name__ == "__main__":
    sys.exit(main())
