"""The public names: a test calls every name of it, and its documentation says what goes in, in which unit."""

import ast
import inspect
import re
from pathlib import Path

import pytest

import calib

HERE = Path(__file__).parent
#: Classes whose methods are called by users; the others are exceptions.
CLASSES = {
    name: value
    for name, value in [*vars(calib).items(), *vars(calib.gap).items()]
    if isinstance(value, type) and name in {*calib.__all__, *calib.gap.__all__} and not issubclass(value, Exception)
}
FUNCTIONS = {
    **{name: getattr(calib, name) for name in calib.__all__ if inspect.isfunction(getattr(calib, name))},
    **{f"gap.{name}": getattr(calib.gap, name) for name in calib.gap.__all__ if inspect.isfunction(getattr(calib.gap, name))},
    **{
        f"{owner}.{name}": getattr(value, "__func__", value)
        for owner, cls in CLASSES.items()
        for name, value in vars(cls).items()
        if not name.startswith("_") and inspect.isfunction(getattr(value, "__func__", value))
    },
}
#: How a number's unit is said: by its name, or in words.
UNIT_IN_NAME = re.compile(r"_(s|hz|deg|ms2|v|rel)$")
UNIT_IN_WORDS = re.compile(r"\b(Hz|s|V|percent|degrees|m/s2|unit|uncertaint(y|ies)|test|over)\b")
PROPERTIES = {name for cls in CLASSES.values() for name, value in vars(cls).items() if isinstance(value, property)}


def dotted(node):
    """`calib.gap.plan` of such an expression; of any other its last name alone."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        return f"{dotted(node.value)}.{node.attr}"
    return ""


def trees():
    return [ast.parse(path.read_text("utf-8")) for path in HERE.glob("*.py")]


def test_every_public_name_is_used_by_a_test():
    nodes = [node for tree in trees() for node in ast.walk(tree)]
    calls = {dotted(node.func) for node in nodes if isinstance(node, ast.Call)}
    reads = {dotted(node) for node in nodes if isinstance(node, ast.Attribute)}
    called = {f"calib.{name}" for name in FUNCTIONS if "." not in name or name.startswith("gap.")}
    assert called <= calls, called - calls
    methods = {name.split(".")[1] for name in FUNCTIONS if name.split(".")[0] in CLASSES}
    used = {name.rsplit(".", 1)[-1] for name in calls if "." in name}
    assert methods <= used, methods - used
    assert PROPERTIES <= {name.rsplit(".", 1)[-1] for name in reads}
    exceptions = {f"calib.{name}" for name in calib.__all__ if isinstance(getattr(calib, name), type)}
    assert exceptions - reads <= {"calib.Document"}, exceptions - reads


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_public_function_says_what_goes_in(name):
    function = FUNCTIONS[name]
    text = inspect.getdoc(function) or ""
    assert text, f"{name} has no docstring"
    for parameter in inspect.signature(function).parameters.values():
        if parameter.name in ("self", "cls", "options", "words") or "``" + parameter.name in text:
            continue
        stated = re.search(rf"^ *\**{parameter.name}: (.*(\n {{8,}}.*)*)", text, re.MULTILINE)
        assert stated, f"{name}: {parameter.name} is not described"
        if "float" in str(parameter.annotation):
            unit = UNIT_IN_NAME.search(parameter.name) or UNIT_IN_WORDS.search(stated.group(1))
            assert unit, f"{name}: {parameter.name} has no unit"


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_public_function_is_typed(name):
    signature = inspect.signature(FUNCTIONS[name])
    untyped = [one.name for one in signature.parameters.values() if one.name not in ("self", "cls") and one.annotation is one.empty]
    assert not untyped and signature.return_annotation is not signature.empty, (name, untyped)


def test_the_stub_has_what_the_native_module_has():
    stub = ast.parse((Path(calib.__file__).parent / "_calib.pyi").read_text("utf-8"))
    stated = {node.name for node in stub.body if isinstance(node, ast.FunctionDef)}
    assert stated == {name for name in dir(calib._calib) if not name.startswith("_")}
    assert (Path(calib.__file__).parent / "py.typed").is_file()
