"""Long journal bearing, unwrapped at its widest gap, with rupture and reformation (README.md). Prints JSON, SI."""

import json
from math import cos, pi

U, ETA, R, C, E, SUPPLY = 5.0, 0.02, 0.025, 50e-6, 0.6, 0.5e6
LENGTH = 2 * pi * R


def gap(x):
    return C * (1 + E * cos(x / R))


def slope(x, flow):
    return 12 * ETA * (U * gap(x) / 2 - flow) / gap(x) ** 3


def simpson(f, a, b, n=4000):
    step = (b - a) / n
    return step / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) * f(a + i * step) for i in range(n + 1))


def bisected(f, low, high):
    sign = f(low) > 0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if (f(middle) > 0) == sign else (low, middle)
    return (low + high) / 2


# Rupture: pressure has come down from the supply to zero where its slope is zero, past the narrowest gap.
rupture = bisected(
    lambda x: SUPPLY + simpson(lambda s: slope(s, U * gap(x) / 2), 0, x, 1000), LENGTH / 2, 0.75 * LENGTH
)
flow = U * gap(rupture) / 2
# Reformation: with the flow that the cavity brings along, pressure rises from zero to the supply at the end.
reformation = bisected(lambda x: simpson(lambda s: slope(s, flow), x, LENGTH, 1000) - SUPPLY, LENGTH / 2 * 1.3, LENGTH)


def moment(a, b, p_a, p_b):
    """int p dx = [x p] - int x dp/dx dx"""
    return b * p_b - a * p_a - simpson(lambda x: x * slope(x, flow), a, b)


place = LENGTH - rupture  # the gap is symmetric
expected = {
    "rupture": rupture,
    "reformation": reformation,
    "flow": flow,
    "flow out": flow,
    "peak pressure": SUPPLY + simpson(lambda x: slope(x, flow), 0, place),
    "place of the peak": place,
    "load": moment(0, rupture, SUPPLY, 0) + moment(reformation, LENGTH, 0, SUPPLY),
}
print(json.dumps(expected, indent=1))
