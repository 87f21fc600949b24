"""The stubs of the native part name what it has, and every public docstring has an example."""

import ast
import inspect
from pathlib import Path

import subcert
from subcert import _native


def parameters(function):
    arguments = function.args
    assert not arguments.posonlyargs and not arguments.kwonlyargs
    return [argument.arg for argument in arguments.args]


def check(node, thing):
    """Compares a stub with what is there."""
    if isinstance(node, ast.ClassDef):
        stubbed = {one.name for one in node.body}
        present = {name for name in vars(thing) if not name.startswith("_") or name in stubbed}
        assert stubbed == present, node.name
        for one in node.body:
            check(one, inspect.getattr_static(thing, one.name))
    elif not any(getattr(one, "id", "") == "property" for one in node.decorator_list):
        thing = getattr(thing, "__func__", thing)
        real = [name for name in inspect.signature(thing).parameters if name != "self"]
        assert [name for name in parameters(node) if name != "self"] == real, node.name


def test_stubs_match():
    stubs = ast.parse((Path(subcert.__file__).parent / "_native.pyi").read_text())
    nodes = [x for x in stubs.body if isinstance(x, (ast.ClassDef, ast.FunctionDef))]
    named = {}
    for node in nodes:
        # The classes of the module are private by name.
        named[node.name] = node
    present = {
        name
        for name, thing in vars(_native).items()
        if callable(thing) and not name.startswith("__")
    }
    assert set(named) == present
    for name, node in named.items():
        check(node, getattr(_native, name))


def test_every_public_name_has_an_example():
    lacking = []
    for name in subcert.__all__:
        thing = getattr(subcert, name)
        if not (inspect.isclass(thing) or inspect.isfunction(thing)):
            continue
        if ">>>" not in (thing.__doc__ or ""):
            lacking.append(name)
        if inspect.isclass(thing):
            for method, function in vars(thing).items():
                public = not method.startswith("_") and inspect.isfunction(function)
                if public and ">>>" not in (function.__doc__ or ""):
                    lacking.append(f"{name}.{method}")
    assert lacking == []
