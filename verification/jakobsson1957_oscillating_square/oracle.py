"""Square plates that open and close between baths, by the independent film (README.md): a quarter of the plates, on
grids and time steps of which the limits are taken one after the other. Needs numpy and scipy; a quarter of an hour.
Prints JSON, SI."""

import json
import math
import sys
from pathlib import Path

import numpy as np

SIDE, BATH, ETA, END = 0.01, 1e6, 1 / 6, 0.7
TIMES = (0.1, 0.3, 0.4, 0.5)
FULL = (0.1,)


def separation(t):
    return 1e-5 * (0.375 + 0.125 * math.cos(4 * math.pi * t))


sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
sys.dont_write_bytecode = True  # a folder of its own among the verifications would be taken for one
from film_in_two_dimensions import Film, limit  # noqa: E402


def integration(n, step):
    s = np.linspace(0, 1, n + 1)
    edges = SIDE / 2 * (0.5 * s + 0.5 * s * s)  # finer towards the bath
    film = Film(edges, edges, lambda x, y: 0 * x, ETA, 0.0, BATH, None, BATH, None)
    film.set_separation(separation(0))
    film.p[:] = BATH
    before, loads, cavity = film.content(), {}, []
    for k in range(1, round(END / step) + 1):
        t = k * step
        film.set_separation(separation(t))
        film.solve(step, before)
        before = film.content()
        if film.cavitated() > 0:
            cavity.append(t)
        for at in TIMES:
            if abs(t - at) < step / 2:
                loads[at] = 4 * film.load() / SIDE
    return loads, cavity[0], cavity[-1] + step


seen = {
    (n, step): integration(n, step)
    for n, step in ((16, 0.00125), (32, 0.00125), (64, 0.00125), (128, 0.00125), (32, 0.0025), (32, 0.000625))
}
result = {}
for at in TIMES:
    load = {key: value[0][at] for key, value in seen.items()}
    grids = [load[n, 0.00125] for n in (16, 32, 64, 128)]
    steps = [load[32, step] for step in (0.0025, 0.00125, 0.000625)]
    # Full films are of second order in the cells; with a cavity of first, as its front moves from cell to cell.
    order = 2 if at in FULL else 1
    last = grids[-1] - grids[-2]
    result[f"load at t = {at} s"] = {
        "on four grids": grids,
        "with three steps": steps,
        "order seen in cells": limit(grids)[1],
        "limit": grids[-1] + last / (2**order - 1) + 2 * (steps[2] - steps[1]),
    }
result["first cavity"] = [value[1] for value in seen.values()]
result["full again"] = [value[2] for value in seen.values()]
print(json.dumps(result, indent=1))
