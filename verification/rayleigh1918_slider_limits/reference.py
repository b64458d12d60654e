"""Load and friction of a plane slider, which many ways lead back to (README.md). Prints JSON, SI."""

import json
from math import log

ETA, U, L, H0, K = 0.02, 5.0, 0.01, 10e-6, 1.0

load = 6 * ETA * U * L**2 / H0**2 * (log(1 + K) / K**2 - 2 / (K * (2 + K)))
friction = ETA * U * L / H0 * (4 * log(1 + K) / K - 6 / (2 + K))
ways = ("smooth", "thins by nothing", "walls of one temperature", "rough by a hundredth", "asperities out of reach")
expected = {f"load, {way}": load for way in ways}
expected |= {f"friction, {way}": friction for way in ways}
expected["load, flooded out of gas"] = load
expected["load, rough by a twentieth"] = load
print(json.dumps(expected, indent=1))
