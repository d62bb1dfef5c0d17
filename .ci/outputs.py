"""Holds the files in a folder against docs/schemas, and shows that each schema can refuse."""

import copy
import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

import jsonschema
import xmlschema

SCHEMAS = pathlib.Path("docs/schemas")


def places(value, path=()):
    """Every value of a document, with the keys that lead to it."""
    yield path, value
    keys = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in keys:
        yield from places(inner, (*path, key))


def one_of_each(found):
    """Of places that differ in numbers and in renderers' names only, the first of each type."""
    seen = set()
    for path, value in found:
        by_name = [i + 1 for i, key in enumerate(path) if key in ("cells", "results")]
        kind = tuple("*" if isinstance(key, int) or i in by_name else key for i, key in enumerate(path))
        if (kind, type(value)) not in seen:
            seen.add((kind, type(value)))
            yield path, value


def damaged(document, optional, choose=iter):
    """Documents that are wrong in one place: a key more, a key less, another type."""
    for path, value in choose(places(document)):
        def changed(change):
            copied = copy.deepcopy(document)
            *way, last = ("root", *path)
            inner = {"root": copied}
            whole = inner
            for key in way:
                inner = inner[key]
            change(inner, last)
            return whole["root"]

        where = "/".join(map(str, path)) or "the whole"
        if isinstance(value, dict):
            yield f"{where} with a key more", changed(lambda a, k: a[k].update(more=1))
            for key in value.keys() - optional:
                yield f"{where} without {key}", changed(lambda a, k: a[k].pop(key))
        # No field may be of any of these types at once.
        for other in ({"x": 1}, "", -1.5, None, True):
            if type(other) is not type(value) and not may_be(path, value, other):
                yield f"{where} as {other!r}", changed(lambda a, k: a.__setitem__(k, other))


def may_be(path, value, other):
    """Whether this other value is as good there: text for text, none where there may be none."""
    if isinstance(other, str):
        return path[-1:] in (("strip",), ("command",), ("kind",))
    if other is None:
        return bool(path) and path[-1] not in ("schema", "name", "verdict", "findings", "green", "total")
    return isinstance(other, float) and isinstance(value, (int, float, type(None)))


def hold_json(file, name, optional=frozenset(), choose=iter):
    """The document is by its schema, and nothing near it is."""
    schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    document = json.loads(file.read_text())
    for error in validator.iter_errors(document):
        sys.exit(f"{file}: {error.json_path}: {error.message}")
    tried = 0
    for what, wrong in damaged(document, optional, choose):
        tried += 1
        if validator.is_valid(wrong):
            sys.exit(f"{name}.schema.json: takes {file.name}, {what}")
    print(f"{file.name}: by {name}.schema.json, which refuses {tried} damaged ones")
    return schema, document


def hold_xml(file, document):
    """The document is by its schema, has what the JSON has, and nothing near it is by the schema."""
    schema = xmlschema.XMLSchema(SCHEMAS / "junit.xsd")
    schema.validate(file)
    root = ElementTree.parse(file).getroot()
    cases = [f"{case.get('classname')}/{case.get('name')}" for case in root.iter("testcase")]
    names = [f"fixtures/{fixture['name']}" for fixture in document["fixtures"]]
    if sorted(cases) != sorted(names):
        sys.exit(f"{file}: expected the fixtures {names}, found {cases}")
    tried = 0
    for i, element in enumerate(root.iter()):
        wrongs = [("with an attribute more", lambda e: e.set("more", "1"))]
        wrongs += [("with an element more", lambda e: ElementTree.SubElement(e, "more"))]
        wrongs += [(f"without {key}", lambda e, key=key: e.attrib.pop(key)) for key in element.attrib]
        wrongs += [(f"with {key} empty", lambda e, key=key: e.set(key, "")) for key in element.attrib]
        for what, change in wrongs:
            wrong = copy.deepcopy(root)
            change(list(wrong.iter())[i])
            tried += 1
            if schema.is_valid(wrong):
                sys.exit(f"junit.xsd: takes {element.tag} {what}")
    print(f"{file.name}: by junit.xsd, which refuses {tried} damaged ones")


def main(folder):
    schema, document = hold_json(folder / "all.json", "check")
    plan_schema, _ = hold_json(folder / "plan.json", "plan", {"blamed"})
    # No document has a renderer's bits change; the schema knows the verdict all the same.
    known = schema["$defs"]["fixture"]["properties"]["verdict"]["enum"]
    found = {fixture["verdict"] for fixture in document["fixtures"]}
    if found | {"unsteady"} != set(known):
        sys.exit(f"expected a fixture of each of {known}, found {sorted(found)}")
    if any(verdict not in document["summary"] for verdict in known):
        sys.exit("expected the summary to count each verdict")
    of_plan = plan_schema["$defs"]["step"]["properties"]["distances"]["oneOf"][1]["properties"]
    of_check = schema["$defs"]["fixture"]["properties"]
    for name, metric in of_plan.items():
        if metric["description"] != of_check[name]["description"]:
            sys.exit(f"{name}: described in two ways by the two schemas")
    hold_xml(folder / "all.xml", document)
    card = folder / "cards/few/scorecard.json"
    ids = {renderer["id"] for renderer in json.loads(card.read_text())["renderers"]}
    hold_json(card, "scorecard", ids, one_of_each)
    hold_json(folder / "cards/empty/scorecard.json", "scorecard")
    hold_json(folder / "cards/grade/grade.json", "grade", choose=one_of_each)


main(pathlib.Path(sys.argv[1]))
