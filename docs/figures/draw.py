#!/usr/bin/env python3
"""Draws the pictures of the documents: drawings from their description, charts from shipped cases.

usage: docs/figures/draw.py [FOLDER]      (environment: PYTHONPATH with the module ringfilm, RINGFILM_DATA)

Writes into folders below FOLDER, without FOLDER next to this file: docs/decisions/0016-pictures-are-stored-as-svg.md.
"""

import importlib
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
MODULES = {  # folder of the pictures: modules that draw them
    "schematic": ("ring_drawings", "other_drawings"),
    "cycle": ("cycle_charts",),
    "model": ("model_charts",),
    "film": ("film_charts",),
    "supply": ("supply_charts",),
    "measured": ("measured_charts",),
    "study": ("study_charts",),
    "life": ("life_charts",),
}


def draw(folder):
    """Writes all pictures; returns their paths below `folder`."""
    sys.path.insert(0, str(HERE))
    written = []
    for kind, modules in MODULES.items():
        (folder / kind).mkdir(parents=True, exist_ok=True)
        for module in modules:
            for name, picture in importlib.import_module(module).PICTURES.items():
                path = folder / kind / f"{name}.svg"
                path.write_text(picture().svg(), encoding="utf-8")
                written.append(path.relative_to(folder).as_posix())
    return written


if __name__ == "__main__":
    draw(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
