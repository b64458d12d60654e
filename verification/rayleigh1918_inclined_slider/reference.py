"""Infinitely wide inclined slider, closed form (README.md). Prints the expected numbers in SI as JSON."""

import json
from math import log1p

U, ETA, RHO, L, H0 = 5.0, 0.02, 850.0, 0.01, 10e-6


def load_factor(k):
    return 6 * (log1p(k) / k**2 - 2 / (k * (2 + k)))


def load(k):
    return load_factor(k) * ETA * U * L**2 / H0**2


def best_inclination():
    """Where the load is largest, by ternary search."""
    low, high = 0.5, 2.5
    for _ in range(100):
        a, b = low + (high - low) / 3, high - (high - low) / 3
        low, high = (a, high) if load_factor(a) < load_factor(b) else (low, b)
    return (low + high) / 2


best = best_inclination()
k = 1.188705
thickest, thinnest = H0 * (1 + k), H0
at_peak = 2 * thickest * thinnest / (thickest + thinnest)
expected = {
    "load at K = 0.3": load(0.3),
    "load at K = 1": load(1.0),
    "load at best K": load(k),
    "load at K = 3": load(3.0),
    "peak pressure at best K": 6
    * ETA
    * U
    * L
    / (thickest - thinnest)
    * (1 / (2 * at_peak) - 1 / (thickest + thinnest)),
    "place of the peak": L * (thickest - at_peak) / (thickest - thinnest),
    "friction on the moving side": ETA * U * L / H0 * (4 * log1p(k) / k - 6 / (2 + k)),
    "friction on the standing side": ETA * U * L / H0 * (6 / (2 + k) - 2 * log1p(k) / k),
    "mass flow": RHO * U * at_peak / 2,
    "K of the largest load": best,
    "load at K = 1, order in cells": load(1.0),
    "friction at best K, order in cells": ETA * U * L / H0 * (4 * log1p(k) / k - 6 / (2 + k)),
}
print(json.dumps(expected, indent=1))
