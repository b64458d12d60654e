"""Journal bearing with two axial grooves: the table of Someya 1989 in the units of the case (README.md). Prints JSON,
SI, angles in degrees."""

import json
from math import pi

ETA, U, R, C = 0.02, 5.0, 0.025, 25e-6

# L/D, eccentricity, attitude [degree], Sommerfeld number, friction coefficient R/c: someya1989, pages 14 and 17
TABLE = [
    (0.5, 0.2, 71.6, 2.07, 39.5),
    (0.5, 0.3, 64.1, 1.24, 24.4),
    (0.5, 0.4, 57.5, 0.798, 16.4),
    (0.5, 0.5, 51.1, 0.517, 11.3),
    (0.5, 0.6, 44.7, 0.323, 7.75),
    (0.5, 0.7, 38.2, 0.187, 5.13),
    (0.5, 0.8, 31.2, 0.0926, 3.13),
    (0.5, 0.9, 22.7, 0.0315, 1.56),
    (1.0, 0.3, 61.0, 0.424, 8.41),
    (1.0, 0.4, 54.6, 0.284, 5.93),
    (1.0, 0.5, 49.1, 0.194, 4.37),
    (1.0, 0.6, 43.8, 0.131, 3.26),
    (1.0, 0.7, 38.4, 0.0828, 2.39),
    (1.0, 0.8, 32.1, 0.0469, 1.69),
    (1.0, 0.9, 25.0, 0.0195, 1.04),
]

expected = {}
for ratio, e, attitude, sommerfeld, friction in TABLE:
    row = f"L/D = {ratio}, e = {e}, "
    turns = U / (2 * pi * R)  # N [1/s]
    expected[row + "load"] = ETA * turns * 2 * R * (R / C) ** 2 / sommerfeld
    expected[row + "attitude"] = attitude
    expected[row + "friction"] = friction * C / R
    expected[row + "direction of the load"] = 90
print(json.dumps(expected, indent=1))
