"""No public name without a docstring; stubs with every member; the examples of the manual."""

import ast
import doctest
import importlib
import inspect
import os
import pathlib
import pkgutil
import shutil

import pytest

import ringfilm
from conftest import SOURCES

# Methods behind operators that users meet as a bracket, a length or a call.
OPERATORS = ("__getitem__", "__setitem__", "__len__", "__call__")


def public_modules():
    """The package and what it has of modules, public by their names: none is omitted for not being listed."""
    return [
        "ringfilm",
        *(
            f"ringfilm.{module.name}"
            for module in pkgutil.iter_modules(ringfilm.__path__)
            if not module.name.startswith("_")
        ),
    ]


def public_names():
    for name in public_modules():
        module = importlib.import_module(name)
        assert module.__doc__, name
        for word in getattr(module, "__all__", [one for one in vars(module) if not one.startswith("_")]):
            thing = getattr(module, word)
            if inspect.ismodule(thing) or not (inspect.isclass(thing) or callable(thing)):
                continue
            if getattr(thing, "__module__", "").split(".")[0] != "ringfilm":
                continue
            yield f"{name}.{word}", thing


def own_words(thing):
    """The docstring without the signature that pybind11 puts in front; empty for the words of Python itself."""
    doc = inspect.getdoc(thing) or ""
    if doc.startswith("Alias for field number"):
        return ""
    first, _, rest = doc.partition("\n")
    return rest.strip() if "->" in first and "(" in first else doc.strip()


def test_every_public_name_is_documented():
    missing = []
    n = 0
    for name, thing in public_names():
        n += 1
        if not own_words(thing):
            missing.append(name)
        if not inspect.isclass(thing):
            continue
        for member, value in vars(thing).items():
            if member.startswith("_") and member not in OPERATORS:
                continue
            if not own_words(value.__func__ if isinstance(value, (staticmethod, classmethod)) else value):
                missing.append(f"{name}.{member}")
    assert n > 40
    assert missing == []


def test_every_result_of_a_function_is_of_a_public_class():
    """Members of a class that no module names would be looked at by no test."""
    import ringfilm._ringfilm as compiled

    named = {thing for _, thing in public_names() if inspect.isclass(thing)}
    inner = [compiled, *(thing for thing in vars(compiled).values() if inspect.ismodule(thing))]
    hidden = [
        thing.__name__
        for module in inner
        for thing in vars(module).values()
        if inspect.isclass(thing) and thing not in named
    ]
    assert len(inner) > 4
    assert hidden == []


def test_functions_that_take_arrays_say_their_unit():
    for name, thing in public_names():
        if inspect.isbuiltin(thing) and "numpy.ndarray" in thing.__doc__.partition("\n")[0]:
            assert "[" in own_words(thing), name


def test_the_stubs_have_every_public_member_with_its_type():
    """Written by the build, so names, signatures and docstrings are those of the module; here: is any missing?"""
    folder = pathlib.Path(ringfilm.__file__).parent / "_ringfilm"
    stubs = {path.stem: ast.parse(path.read_text(encoding="utf-8")) for path in folder.glob("*.pyi")}
    assert set(stubs) == {"__init__", "face", "lateral_force", "laws", "surface"}
    stated, untyped = set(), set()
    for stub in stubs.values():
        for node in stub.body:
            stated.add(getattr(node, "name", None))
            for member in getattr(node, "body", []):
                if isinstance(member, ast.FunctionDef) and isinstance(node, ast.ClassDef):
                    stated.add(f"{node.name}.{member.name}")
                    if member.decorator_list and ast.unparse(member.returns) == "object":
                        untyped.add(f"{node.name}.{member.name}")
    assert untyped <= {
        "Field.default",  # a number, a text or None
        "Result.read",  # a Result or a PackResult
        "Case.new",  # made by the plain layer
        "Case.copy",
        "PackResult.gas",
    }
    missing = []
    for _, thing in public_names():
        if not thing.__module__.startswith("ringfilm._ringfilm"):
            continue
        members = vars(thing) if inspect.isclass(thing) else ()
        names = [thing.__name__, *(f"{thing.__name__}.{name}" for name in members if not name.startswith("_"))]
        missing += [name for name in names if name not in stated]
    assert missing == []


def test_the_examples_of_the_manual_run(tmp_path, monkeypatch):
    pytest.importorskip("xarray")
    pytest.importorskip("matplotlib")
    for name in ("cases", "data"):
        shutil.copytree(SOURCES / name, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    page = SOURCES / "docs" / "manual" / "python.md"
    failed, tried = doctest.testfile(
        str(page), module_relative=False, optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
    )
    assert tried > 30 and failed == 0


def test_the_module_says_its_version():
    assert ringfilm.version().startswith("ringfilm ")
    assert pathlib.Path(os.path.dirname(ringfilm.__file__), "py.typed").exists()
