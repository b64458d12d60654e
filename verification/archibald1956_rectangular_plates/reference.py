"""Squeeze between parallel rectangular plates: the series of README.md. Prints JSON, SI."""

import json
from math import cosh, pi, tanh

ETA = 0.03
B = 0.01  # the shorter side [m]
APPROACH = 10e-6 / 10e-3  # 20 um at t = 0, 10 um at t = 10 ms


def beta(ratio):
    """Load over eta V a b^3/h^3, with the longer side a = ratio b."""
    return 1 - 192 / pi**5 / ratio * sum(tanh(n * pi * ratio / 2) / n**5 for n in range(1, 400, 2))


def centre(ratio):
    """Pressure in the middle over that between plates of endless length, 1.5 eta V b^2/h^3."""
    terms = ((-1) ** (n // 2) / (n**3 * cosh(n * pi * ratio / 2)) for n in range(1, 60, 2))
    return 1 - 32 / pi**3 * sum(terms)


def load(ratio, h):
    return beta(ratio) * ETA * APPROACH * ratio * B**4 / h**3


h = 10e-6
expected = {
    "square, load": load(1, h) / B,
    "square, pressure in the middle": 1.5 * ETA * APPROACH * B**2 / h**3 * centre(1),
    "square, load at h = 15 um": load(1, 15e-6) / B,
    "a/b = 2, load": load(2, h) / (2 * B),
    "a/b = 3, load": load(3, h) / (3 * B),
    "a/b = 10, load": load(10, h) / (10 * B),
    "a/b = 2, turned by a quarter, load": load(2, h) / B,
}
expected["square, order in cells"] = expected["square, load"]
if __name__ == "__main__":
    print(json.dumps(expected, indent=1))
