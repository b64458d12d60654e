"""No public name without a docstring; stubs that match the module; the examples of the manual."""

import doctest
import importlib
import inspect
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

import ringfilm
from conftest import SOURCES

MODULES = ["ringfilm", "ringfilm.surface", "ringfilm.face", "ringfilm.lateral_force", "ringfilm.laws", "ringfilm.errors"]


def public_names():
    for name in MODULES:
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
    """The docstring without the signature that pybind11 puts in front."""
    doc = inspect.getdoc(thing) or ""
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
            if member.startswith("_") and member not in ("__getitem__", "__setitem__", "__len__", "__call__"):
                continue
            if member in ("args", "with_traceback", "add_note"):
                continue
            if not own_words(value.__func__ if isinstance(value, staticmethod) else value):
                missing.append(f"{name}.{member}")
    assert n > 40
    assert missing == []


def test_functions_that_take_arrays_say_their_unit():
    for name, thing in public_names():
        if inspect.isbuiltin(thing) and "numpy.ndarray" in thing.__doc__.partition("\n")[0]:
            assert "[" in own_words(thing), name


def test_the_stubs_are_what_the_module_says():
    done = subprocess.run([sys.executable, str(SOURCES / "script" / "python-stubs"), "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_the_examples_of_the_manual_run(tmp_path, monkeypatch):
    pytest.importorskip("xarray")
    pytest.importorskip("matplotlib")
    for name in ("cases", "data"):
        shutil.copytree(SOURCES / name, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    page = SOURCES / "docs" / "manual" / "python.md"
    failed, tried = doctest.testfile(str(page), module_relative=False, optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
    assert tried > 30 and failed == 0


def test_the_module_says_its_version():
    assert ringfilm.version().startswith("ringfilm ")
    assert pathlib.Path(os.path.dirname(ringfilm.__file__), "py.typed").exists()
