"""The parallel pad with four pockets by the independent film (README.md): on three grids, and what they run to. Needs
numpy and scipy; a minute. `--gap` writes the map instead. Prints JSON, SI."""

import json
import sys
from pathlib import Path

SIDE, LAND, DEPTH = 0.08, 15e-6, 12e-6
EDGES = (0.006, 0.034, 0.046, 0.074)  # of the pockets, along x and along y

if sys.argv[1:] == ["--gap"]:
    places = (0, *(edge for edge in EDGES for _ in range(2)), SIDE)
    inside = (False, False, True, True, False, False, True, True, False, False)
    print("x [mm],y [mm],h [um]")
    for y, across in zip(places, inside):
        for x, along in zip(places, inside):
            print(f"{1e3 * x:.6g},{1e3 * y:.6g},{1e6 * (LAND + (DEPTH if across and along else 0)):.6g}")
    sys.exit()

import numpy as np  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # a folder of its own among the verifications would be taken for one
from film_in_two_dimensions import Film, limit  # noqa: E402

AMBIENT, CAVITATION = 1e5, 0.3e5


def pocket(s):
    return ((s > EDGES[0]) & (s < EDGES[1])) | ((s > EDGES[2]) & (s < EDGES[3]))


def film(n):
    over = AMBIENT - CAVITATION
    return Film(
        np.linspace(0, SIDE, 40 * n + 1),
        np.linspace(0, SIDE / 2, 20 * n + 1),
        lambda x, y: LAND + DEPTH * (pocket(x) & pocket(y)),
        0.03,
        1.0,
        over,
        over,
        over,
        None,
    )


seen = {"load": [], "peak": [], "mass flow in": [], "mass flow through one side": [], "cavitated": []}
for n in (3, 6, 12):
    pad = film(n)
    pad.solve()
    flows = pad.flows()
    seen["load"].append(2 * pad.load() / SIDE + CAVITATION * SIDE)
    seen["peak"].append(pad.peak() + CAVITATION)
    seen["mass flow in"].append(-2 * 850 * flows["left"] / SIDE)
    seen["mass flow through one side"].append(850 * flows["front"])
    seen["cavitated"].append(pad.cavitated())
print(
    json.dumps(
        {name: {"on three grids": values, "limit": limit(values, order=1)[0]} for name, values in seen.items()},
        indent=1,
    )
)
