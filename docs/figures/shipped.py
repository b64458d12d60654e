"""Cases and results that several pictures draw; each is computed once."""

import functools
import pathlib
import tempfile

import ringfilm

ROOT = pathlib.Path(__file__).resolve().parents[2]
RINGS = ("new", "run-in", "embedded")


def case(path, **changes):
    """A shipped case with changes; of their keys "." is written "__"."""
    changed = ringfilm.Case.read(str(ROOT / "cases" / path))
    changed.update({key.replace("__", "."): value for key, value in changes.items()})
    return changed


@functools.lru_cache(maxsize=None)
def ring(name):
    """One of the three rings of styles2014 with its cycle."""
    return case(f"styles2014/{name}.toml").run()


def starting_case():
    """The case that `ringfilm new` writes."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "start.toml"
        path.write_text(ringfilm.starting_case(), encoding="utf-8")
        return ringfilm.Case.read(str(path))


def oil(grade):
    return ROOT / "data" / "lubricants" / f"{grade}.toml"
