"""Shares of hydrogen in two volumes in series under a constant flow (README.md). Prints JSON."""

import json
import math

# The gas path: 20 bar, three end gaps, all choked.
R, T, C, P, GAMMA = 287.0, 400.0, 0.65, 20e5, 1.33
AREAS, VOLUMES = (0.01e-6, 0.03e-6, 0.09e-6), (0.1e-6, 0.6e-6)
CYCLE = 0.08  # s, 720 degrees at 1500 rpm
# The charge and the crank.
LAMBDA, RESIDUAL, BURNT_AT = 2.0, 0.05, 50
CRANK, ROD = 0.0795 / 2, 0.1381
AIR = {28.0134e-3: 0.78084, 31.9988e-3: 0.20946, 39.948e-3: 0.00934, 44.0095e-3: 0.00036}  # kg/mol: moles
M_HYDROGEN, M_OXYGEN = 2.01588e-3, 31.9988e-3


def flow():
    return C * AREAS[0] * P / math.sqrt(R * T) * math.sqrt(GAMMA) * (2 / (GAMMA + 1)) ** ((GAMMA + 1) / (2 * GAMMA - 2))


def burnt_at(degree):
    """Residual gas until the step, burnt gas until the gas exchange, then what the intake dilutes."""
    degree %= 720
    if degree < BURNT_AT or degree >= 540:
        return RESIDUAL
    if degree <= 360:
        return 1.0
    angle = math.radians(degree)
    below = CRANK * (1 - math.cos(angle)) + ROD - math.sqrt(ROD**2 - (CRANK * math.sin(angle)) ** 2)
    return RESIDUAL / (RESIDUAL + (1 - RESIDUAL) * below / (2 * CRANK))


def shares():
    """Fresh charge in both volumes at each degree of the periodic cycle, from exponentials: linear between degrees."""
    m = flow()
    a, b = (m * R * T / (pressure * volume) for pressure, volume in zip(pressures(), VOLUMES, strict=True))
    fresh = [1 - burnt_at(k) for k in range(721)]
    h = CYCLE / 720
    y1 = y2 = 0.5
    for _ in range(60):  # cycles
        cycle = []
        for k in range(720):
            cycle.append((y1, y2))
            c0, slope = fresh[k], (fresh[k + 1] - fresh[k]) / h
            # y1 = p + slope t + A exp(-a t); y2 follows by variation of constants.
            p = c0 - slope / a
            big_a = y1 - p
            q1 = p - slope / b
            big_b = y2 - q1 - b / (b - a) * big_a
            y1 = p + slope * h + big_a * math.exp(-a * h)
            y2 = q1 + slope * h + b / (b - a) * big_a * math.exp(-a * h) + big_b * math.exp(-b * h)
    return cycle


def pressures():
    return P * AREAS[0] / AREAS[1], P * AREAS[0] / AREAS[2]


air_mass = sum(molar_mass * moles for molar_mass, moles in AIR.items())
air_moles = sum(AIR.values()) / air_mass  # of 1 kg
oxygen = AIR[M_OXYGEN] / air_mass  # moles in 1 kg
hydrogen = 2 * oxygen * M_HYDROGEN / LAMBDA  # kg for 1 kg of air
in_charge = hydrogen / (1 + hydrogen)
cycle = shares()
mean_fresh = sum((1 - burnt_at(k) + 1 - burnt_at(k + 1)) / 2 for k in range(720)) / 720
fuel_moles = hydrogen / M_HYDROGEN
fresh_moles = (air_moles + fuel_moles) / (1 + hydrogen)  # of 1 kg
burnt_moles = (air_moles - fuel_moles / 2 + fuel_moles) / (1 + hydrogen)
crankcase_moles = mean_fresh * fresh_moles + (1 - mean_fresh) * burnt_moles
expected = {
    "hydrogen in the first volume": in_charge * max(y1 for y1, _ in cycle),
    "hydrogen in the second volume": in_charge * max(y2 for _, y2 in cycle),
    "hydrogen in the crankcase": mean_fresh * in_charge / M_HYDROGEN / crankcase_moles,
}
print(json.dumps(expected, indent=1))
