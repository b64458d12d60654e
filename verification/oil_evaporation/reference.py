"""Evaporation of oil and transfer of heat in closed form (README.md). Prints JSON, SI."""

import json
from math import cos, exp, log, pi, sin, sqrt

GAS = 8.314462618
BETA, WALL = 0.02, 393.15


def vapour_pressure(boiling, temperature):
    return 101325 * exp((4.4 + log(boiling)) * (1 - boiling / temperature))


def flux(boiling, molar_mass, temperature, beta):
    return beta * molar_mass * vapour_pressure(boiling, temperature) / (GAS * temperature)


def mean_distance(stroke=79.5e-3, rod=138.1e-3, n=7200):
    """Mean distance of the piston from its TDC position over a turn; the trapezoids are exact on a period."""
    r = stroke / 2
    angles = (2 * pi * k / n for k in range(n))
    return sum(r * (1 - cos(a)) + rod - sqrt(rod**2 - (r * sin(a)) ** 2) for a in angles) / n


def two_fractions(time, steps=20000):
    """Masses of two fractions of a film by the Runge-Kutta method: dn_i/dt = -beta c_i n_i/(n_1 + n_2)."""
    boiling, molar_mass, share, mass, temperature = (700.0, 790.0), (0.33, 0.45), (0.4, 0.6), 8e-4, 450.0
    rate = [BETA * vapour_pressure(b, temperature) / (GAS * temperature) for b in boiling]
    n = [mass * s / m for s, m in zip(share, molar_mass)]

    def slope(n):
        return [-c * one / sum(n) for c, one in zip(rate, n)]

    h = time / steps
    for _ in range(steps):
        a = slope(n)
        b = slope([x + 0.5 * h * k for x, k in zip(n, a)])
        c = slope([x + 0.5 * h * k for x, k in zip(n, b)])
        d = slope([x + h * k for x, k in zip(n, c)])
        n = [x + h / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip(n, a, b, c, d)]
    return sum(x * m for x, m in zip(n, molar_mass)) / mass, n[0] / sum(n)


def main():
    ring = flux(793.15, 0.4, WALL, BETA) * pi * 89e-3 * mean_distance()
    drying = 8e-4 / flux(760, 0.4, 440, BETA)
    left, light = two_fractions(1.0)
    later_left, later_light = two_fractions(4.0)
    return {
        "one fraction above a ring": ring,
        "one fraction, stated by its vapour pressure": vapour_pressure(760, 440),
        "film at half its drying time": 1 - 5.5 / drying,
        "film just before it is dry": 1 - 11.0 / drying,
        "two fractions, mass": left,
        "two fractions, light one": light,
        "two fractions later, mass": later_left,
        "two fractions later, light one": later_light,
        "one fraction in the Noack test": 0.253 * vapour_pressure(780, 523.15) / (GAS * 523.15) * 0.4 / 65e-3,
        "molar mass": 1e-3 * ((6.97996 - log(1080 - 760)) / 0.01964) ** 1.5,
        "Woschni": 3.26 * 0.089**-0.2 * 5000**0.8 * 1800**-0.55 * 20**0.8,
    }


print(json.dumps(main(), indent=1))
