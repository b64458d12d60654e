#!/usr/bin/env python3
"""Draws the pictures of the documents: `schematic` ones from their description, `computed` ones from shipped cases.

usage: docs/figures/draw.py [FOLDER]      (environment: PYTHONPATH with the module ringfilm, RINGFILM_DATA)

Writes FOLDER/schematic and FOLDER/computed, without FOLDER those next to this file. docs/decisions has the reasons.
"""

import importlib
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
MODULES = {
    "schematic": ("ring_drawings", "other_drawings"),
    "computed": ("cycle_charts", "model_charts", "film_charts", "measured_charts", "study_charts"),
}


def draw(folder, kinds=tuple(MODULES)):
    """Writes all pictures of these kinds; returns their paths below `folder`."""
    sys.path.insert(0, str(HERE))
    written = []
    for kind in kinds:
        (folder / kind).mkdir(parents=True, exist_ok=True)
        for module in MODULES[kind]:
            for name, picture in importlib.import_module(module).PICTURES.items():
                path = folder / kind / f"{name}.svg"
                path.write_text(picture().svg(), encoding="utf-8")
                written.append(path.relative_to(folder).as_posix())
    return written


if __name__ == "__main__":
    draw(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
