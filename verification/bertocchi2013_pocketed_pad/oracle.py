"""The pad with one pocket by the independent film (README.md): on three grids, and what they run to. Needs numpy and
scipy; a minute. `--gap 10` or `--gap 300` writes the map for that width [mm] instead. Prints JSON, SI."""

import json
import sys
from pathlib import Path

LENGTH, BEGIN, END, DEPTH = 0.02, 0.004, 0.010, 0.4e-6
SHARE = 0.7  # of the width
INLET, OUTLET = 1.1e-6, 1.0e-6


def wedge(x):
    return INLET + (OUTLET - INLET) * x / LENGTH


def write_map(width):
    first, last = width * (1 - SHARE) / 2, width * (1 + SHARE) / 2
    print("x [mm],y [mm],h [um]")
    for j, y in enumerate((0, first, first, last, last, width)):
        for i, x in enumerate((0, BEGIN, BEGIN, END, END, LENGTH)):
            pocket = DEPTH if i in (2, 3) and j in (2, 3) else 0
            print(f"{1e3 * x:.6g},{1e3 * y:.6g},{1e6 * (wedge(x) + pocket):.6g}")


if len(sys.argv) == 3 and sys.argv[1] == "--gap":
    write_map(1e-3 * float(sys.argv[2]))
    sys.exit()

import numpy as np  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # a folder of its own among the verifications would be taken for one
from film_in_two_dimensions import Film, limit  # noqa: E402


def crowded(n, begin, end, both):
    """Edges of n cells, a seventh to a tenth as long at the beginning as elsewhere (at both ends)."""
    s = np.linspace(0, 1, n + 1)
    t = 0.15 * s + 0.85 * 0.5 * (1 - np.cos(np.pi * s)) if both else 0.1 * s + 0.9 * (1 - np.cos(0.5 * np.pi * s))
    return begin + (end - begin) * t


def film(n, width):
    edge = width * (1 - SHARE) / 2
    y = np.concatenate([crowded(15 * n, 0, edge, True), crowded(12 * n, edge, width / 2, False)[1:]])

    def gap(x, y):
        return wedge(x) + DEPTH * ((x > BEGIN) & (x < END) & (y > edge))

    return Film(
        np.linspace(0, LENGTH, 60 * n + 1),
        y,
        gap,
        0.01,
        1.0,
        1e5,
        1e5,
        1e5,
        None,
        viscosity=lambda p: np.exp(1.2e-8 * p),
        density=lambda p: (2.22e9 + 1.66 * p) / (2.22e9 + p),
    )


result = {}
for width in (0.01, 0.3):
    seen = {"load": [], "peak": [], "mass flow in": [], "mass flow through one side": []}
    for n in (2, 4, 8):
        pad = film(n, width)
        pad.solve()
        flows = pad.flows()
        seen["load"].append(2 * pad.load() / width)
        seen["peak"].append(pad.peak())
        seen["mass flow in"].append(-2 * 850 * flows["left"] / width)
        seen["mass flow through one side"].append(850 * flows["front"])
    for name, values in seen.items():
        result[f"{1e3 * width:.0f} mm, {name}"] = {"on three grids": values, "limit": limit(values, order=1)[0]}
print(json.dumps(result, indent=1))
