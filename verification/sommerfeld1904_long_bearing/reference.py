"""Long journal bearing, full film, unwrapped: h = c (1 + e cos(x/R)) (README.md). Prints JSON, SI."""

import json
from math import acos, pi, sin, cos, sqrt

U, ETA, R, C, E, EDGE = 5.0, 0.02, 0.025, 50e-6, 0.6, 20e6


def pressure(angle):
    scale = 6 * ETA * U * R / C**2
    return EDGE + scale * E * sin(angle) * (2 + E * cos(angle)) / ((2 + E**2) * (1 + E * cos(angle)) ** 2)


peak = acos(-3 * E / (2 + E**2))
expected = {
    "load": EDGE * 2 * pi * R,
    "peak pressure": pressure(peak),
    "place of the peak": R * peak,
    "journal load": ETA * U * R**2 / C**2 * 12 * pi * E / ((2 + E**2) * sqrt(1 - E**2)),
    "direction of the journal load": 90,
    "attitude": 90,
    "flow": U * C * (1 - E**2) / (2 + E**2),
    "friction on the moving side": ETA * U * R / C * 4 * pi * (1 + 2 * E**2) / ((2 + E**2) * sqrt(1 - E**2)),
    "friction on the fixed side": ETA * U * R / C * 4 * pi * sqrt(1 - E**2) / (2 + E**2),
}
print(json.dumps(expected, indent=1))
