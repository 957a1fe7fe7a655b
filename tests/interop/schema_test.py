"""The schema in assets/ and the program's own reader say the same about every document.

usage: schema_test.py PROGRAM
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "splineloft"

try:
    import jsonschema

    Validator = jsonschema.Draft202012Validator
except (ImportError, AttributeError) as error:
    print(f"python3-jsonschema with draft 2020-12 is missing: {error}", file=sys.stderr)
    sys.exit(1 if os.environ.get("CI") else SKIPPED)

failures = []


def expect(good, words):
    if not good:
        failures.append(words)
        print(f"FAILED: {words}", file=sys.stderr)


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60)


def document(*curves, **others):
    return {"format": "splineloft", "version": 1, "curves": list(curves), **others}


def curve(family="cardinal", **keys):
    good = {"family": family, "points": [[0, 1], [2, 3], [4, 4], [5, 1]]}
    if family == "hermite":
        good["tangents"] = [[1, 0]] * 4
    good.update(keys)
    return {key: value for key, value in good.items() if value is not None}


def cases_of_families(families):
    """Every family with every ending and around the limits of its parameters."""
    for family in families:
        name = family["id"]
        yield True, document(curve(name))
        yield family["closable"], document(curve(name, closed=True))
        for ends in ["none", "open", "doubled", "reflected", "clamped", "loop"]:
            known = ends in family["ends"]
            yield known, document(curve(name, ends=ends))
            if family["closable"]:
                yield known or ends == "none", document(curve(name, ends=ends, closed=True))
        for parameter in family["parameters"]:
            least, most = parameter["range"]
            for value, good in [(least, True), (most, True), (parameter["neutral"], True),
                                (least - 1, False), (most + 1, False), ("1", False),
                                (None, False), (True, False), ([1], False),
                                (least + 0.5, parameter["scale"] != "whole")]:
                yield good, document(curve(name, parameters={parameter["key"]: value}))
        yield False, document(curve(name, parameters={"slack": 1}))
        yield name == "hermite", document(curve(name, tangents=[[1, 0]] * 4))
        yield name != "hermite", document(curve(name, tangents=None))
        yield from cases_of_lists(family)


def cases_of_lists(family):
    """Knots, weights and local parameters, of four points, where the family has them and where not."""
    name, closable = family["id"], family["closable"]
    for key in ["knots", "weights", "local"]:
        for value in [[], {}, 1, None, "1", [None], ["1"]]:
            # Without any entry, `local` says nothing, which is right where there could be one.
            empty = key == "local" and value == {} and has_local(family)
            case = curve(name)
            case[key] = value
            yield empty, document(case)
    knots = family["knots"]
    cubic = [0, 0, 0, 0, 1, 1, 1, 1]
    yield knots, document(curve(name, knots=cubic))
    yield knots, document(curve(name, knots=[-1e300, 0, 0, 0, 1, 1, 1, 1e300]))
    yield False, document(curve(name, knots=[-1.1e300, 0, 0, 0, 1, 1, 1, 1]))
    yield False, document(curve(name, knots=[0, 0, 0, 0, 1, 1, 1, "1"]))
    yield knots, document(curve(name, knots=[1, 2, 4, 8, 16], closed=True))
    yield knots, document(curve(name, knots=[0, 0, 1, 2, 3, 3], parameters={"degree": 1}))
    for ends in ["none", "open", "doubled", "reflected", "clamped"]:
        yield knots and ends == "none", document(curve(name, knots=cubic, ends=ends))
        yield (knots and ends == "none",
               document(curve(name, knots=[0, 1, 2, 3, 4], ends=ends, closed=True)))
    for weights, good in [([1, 2, 3, 4], True), ([1e-9, 1e9, 1, 0.5], True), ([1, 1, 1, 0], False),
                          ([1, -1, 1, 1], False), ([1, 1, 2e9, 1], False), ([1, 1, 1, None], False)]:
        yield good and family["weights"], document(curve(name, weights=weights))
        yield (good and family["weights"] and closable,
               document(curve(name, weights=weights, closed=True)))
    yield False, document(curve(name, local={"slack": [0, 0, 0, 0]}))
    for parameter in family["parameters"]:
        key, (least, most) = parameter["key"], parameter["range"]
        for values, good in [([least] * 4, True), ([least, parameter["neutral"], most, most], True),
                             ([least, most, most, most + 1], False), ([least - 1] * 4, False),
                             ([], False), ([None] * 4, False), (least, False), ("1111", False)]:
            good = good and parameter["local"]
            yield good, document(curve(name, local={key: values}))
            yield good and closable, document(curve(name, local={key: values}, closed=True))
    if has_local(family):
        every = {parameter["key"]: [parameter["neutral"]] * 4
                 for parameter in family["parameters"] if parameter["local"]}
        yield True, document(curve(name, local=every))


def has_local(family):
    return any(parameter["local"] for parameter in family["parameters"])


def cases_of_curves():
    yield False, document(curve(family="spline"))
    yield False, document(curve(family=None))
    yield False, document(curve(points=None))
    yield False, document(curve(colour="red"))
    yield False, document(None)
    yield True, document(curve(name=""))
    yield True, document(curve(name="Straße\n曲线"))
    yield False, document(curve(name=1))
    yield False, document(curve(name="a\0b"))
    yield False, document(curve(closed=1))
    yield False, document(curve(parameters=[]))
    for points, good in [([], True), ([[1, 2]], True), ([[]], False),
                         ([1, 2], False), ([[1, "2"]], False), ([[1, None]], False),
                         ([[1e9, -1e9]], True), ([[1.1e9, 0]], False), ([[0, -1e300]], False),
                         ([[0.1, 1e-300]], True), ({}, False)]:
        yield good, document(curve(points=points, coordinates=["x", "y"]))
    yield True, document(curve(points=[[0] * 16]))
    yield False, document(curve(points=[[0] * 17]))
    yield True, document(curve("bezier", points=[[0, i] for i in range(256)]))
    yield False, document(curve("bezier", points=[[0, i] for i in range(257)]))
    for names, good in [(["x", "y"], True), (["x", "x"], False), (["x", ""], False), ([], False),
                        (["x", 1], False), ("xy", False), (["ä", "b/~"], True)]:
        yield good, document(curve(coordinates=names))
    yield True, document(curve(degree=None, family="b-spline", parameters={"degree": 3.0}))


def cases_of_documents():
    yield True, document()
    yield True, document(curve(), curve("linear"), curve("hermite"))
    yield True, document(extras={"anything": [1, {"goes": None}]})
    spline = curve("bezier-spline")
    handled = [{"visible": False, "locked": True, "colour": 7, "handles": {"0": "automatic", "3": "corner"}}, {}]
    for good, own in [(True, {}), (True, {"curves": []}), (True, {"curves": handled}), (False, []),
                      (False, {"camera": 1}), (False, {"curves": [{"color": 1}]}),
                      (False, {"curves": [{"colour": 8}]}), (False, {"curves": [{"visible": 0}]}),
                      (False, {"curves": [{"handles": {"03": "corner"}}]}),
                      (False, {"curves": [{"handles": {"3": "round"}}]})]:
        yield good, document(spline, spline, extras={"splineloft": own, "others": 1})
    yield True, {"$schema": "https://example.org/x", **document()}
    yield False, {"$schema": 1, **document()}
    yield False, document(extras=[])
    yield False, document(camera={})
    yield True, document(version=1.0)
    for version in [0, 2, "1", True, None]:
        yield False, document(version=version)
    yield False, document(format="gltf")
    yield False, document(format=None)
    for key in ["format", "version", "curves"]:
        whole = document()
        del whole[key]
        yield False, whole
    for other in [[], {}, 1, "splineloft", None, True]:
        yield False, other


def cases_beyond_a_schema():
    """What only the program can see: that lists are equally long, knots in order, anchors there."""
    yield document(curve(points=[[1, 2], [3]]))
    yield document(extras={"splineloft": {"curves": [{}]}})
    for anchor in ["1", "6"]:
        yield document(curve("bezier-spline"), extras={"splineloft": {"curves": [{"handles": {anchor: "corner"}}]}})
    yield document(curve(), extras={"splineloft": {"curves": [{"handles": {"0": "corner"}}]}})
    yield document(curve(points=[[1]], coordinates=["x", "y"]))
    yield document(curve("hermite", tangents=[[1, 0]]))
    yield document(curve("hermite", tangents=[[1]] * 4))
    yield document(curve("nurbs", weights=[1, 1, 1]))
    yield document(curve("nurbs", weights=[1] * 5))
    for key in ["tension", "bias"]:
        yield document(curve("beta", local={key: [1] * 3}))
        yield document(curve("kochanek-bartels", local={key: [1] * 5}))
    yield document(curve("cardinal", local={"tension": [1] * 3}))
    for name in ["b-spline", "nurbs"]:
        for knots in [[0, 1, 2, 3, 4, 5, 6], [0, 1, 2, 3, 4, 5, 6, 7, 8], [0, 0, 0, 1, 0, 1, 1, 1],
                      [0, 0, 0, 0, 0, 1, 1, 1], [2] * 8, [0, 0, 0, 1, 1, 1, 1, 2], [0]]:
            yield document(curve(name, knots=knots))
        for knots in [[0, 1, 2, 3], [0, 1, 2, 3, 4, 5], [0, 1, 3, 2, 4], [1] * 5, [0, 1, 1, 1, 1]]:
            yield document(curve(name, knots=knots, closed=True))


def check_cases(validator, families, folder):
    cases = [*cases_of_families(families), *cases_of_curves(), *cases_of_documents()]
    beyond = list(cases_beyond_a_schema())
    cases += [(False, case) for case in beyond]
    for index, (_, case) in enumerate(cases):
        (folder / f"{index}.json").write_text(json.dumps(case))
    files = [str(folder / f"{index}.json") for index in range(len(cases))]
    ran = run("check", *files)
    accepted = {line.split(":")[0] for line in ran.stdout.splitlines()}
    refused = {line.split(":")[0] for line in ran.stderr.splitlines()}
    expect(len(accepted) + len(refused) == len(cases), f"{len(cases)} files need a verdict each")
    for file, (good, case) in zip(files, cases):
        shown = json.dumps(case)[:200]
        expect((file in accepted) == good, f"the program should say {good}: {shown}")
        expect(validator.is_valid(case) == (good or case in beyond), f"the schema should say {good}: {shown}")
    return len(cases)


def check_examples(validator):
    examples = sorted((ROOT / "assets/examples").glob("*.json"))
    expect(len(examples) > 0, "there are examples")
    ran = run("check", *map(str, examples))
    expect(ran.returncode == 0, f"the program takes every example: {ran.stderr}")
    for example in examples:
        for error in validator.iter_errors(json.loads(example.read_text())):
            expect(False, f"{example.name}: {error.message}")


def check_catalog(schema, families):
    """Same families in the same order, same parameters, same ranges, neutral value, ends."""
    named = schema["$defs"]["curve"]["properties"]["family"]["enum"]
    expect(named == [family["id"] for family in families], f"families of the schema: {named}")
    for family in families:
        described = schema["$defs"][family["id"]]["properties"]
        parameters = described["parameters"].get("properties", {})
        keys = [parameter["key"] for parameter in family["parameters"]]
        expect(list(parameters) == keys, f"{family['id']}: parameters {list(parameters)} for {keys}")
        for parameter in family["parameters"]:
            entry = parameters.get(parameter["key"], {})
            found = [entry.get("minimum"), entry.get("maximum"), entry.get("default")]
            wanted = [*parameter["range"], parameter["neutral"]]
            expect(found == wanted, f"{family['id']}.{parameter['key']}: {found} for {wanted}")
        local = [parameter for parameter in family["parameters"] if parameter["local"]]
        entries = described.get("local", {}).get("properties", {})
        expect(list(entries) == [parameter["key"] for parameter in local],
               f"{family['id']}: local {list(entries)}")
        for parameter in local:
            items = entries.get(parameter["key"], {}).get("items", {})
            found = [items.get("minimum"), items.get("maximum")]
            expect(found == parameter["range"],
                   f"{family['id']}, local {parameter['key']}: {found} for {parameter['range']}")


def main():
    schema = json.loads((ROOT / "assets/splineloft.schema.json").read_text())
    Validator.check_schema(schema)
    validator = Validator(schema)
    families = json.loads(run("families", "--json").stdout)
    check_catalog(schema, families)
    check_examples(validator)
    with tempfile.TemporaryDirectory() as folder:
        count = check_cases(validator, families, pathlib.Path(folder))
    print(f"{count} documents, {len(failures)} disagreements")
    sys.exit(1 if failures else 0)


main()
