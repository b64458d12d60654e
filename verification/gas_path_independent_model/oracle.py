"""The ring pack of README.md by scipy's Radau method, written from the equations alone; no line of the program.

usage: oracle.py SPEED_RPM seated|axial [CYCLES]

Unknowns are masses, positions and velocities; events are located by scipy. Prints blow-by, peaks and events.
"""

import pathlib
import sys

import numpy
from scipy.integrate import solve_ivp

R, GAMMA, MU, C, EPS = 287.0, 1.33, 2.5e-5, 0.65, 1e-3
BORE, CRANK, ROD = 0.089, 0.0795 / 2, 0.1381
P_CRANKCASE, T_CHAMBER, U_0, OIL_GAP = 101325.0, 600.0, 0.05, 0.3e-6
GAP, CLEARANCE, LAND, THICKNESS, P_E, FRICTION = 0.08e-6, 50e-6, 0.2e-3, 3.5e-3, 0.2e6, 0.05
WIDTH = (1.2e-3, 1.5e-3)
MASS = [7200 * width * THICKNESS * numpy.pi * (BORE - THICKNESS) for width in WIDTH]
VOLUME = numpy.array([0.3e-6, 0.5e-6, 0.2e-6, 0.3e-6])  # groove 1, land 2, groove 2, land 3
TEMPERATURE = numpy.array([500.0, 450.0, 450.0, 400.0])
RT_V = R * TEMPERATURE / VOLUME
OUTER, INNER = BORE - 2 * LAND, BORE - 2 * THICKNESS

TRACE = pathlib.Path(__file__).parents[2] / "cases" / "styles2014" / "cylinder_pressure_1500rpm_synthetic.csv"
ANGLE, PRESSURE = numpy.loadtxt(TRACE, delimiter=",", skiprows=1, unpack=True)
ANGLE, PRESSURE = numpy.append(ANGLE, 720.0), numpy.append(PRESSURE, PRESSURE[0])


def flow_function(r):
    if r > 1 - EPS:
        return flow_function(1 - EPS) * (1 - r) / EPS
    r = max(r, (2 / (GAMMA + 1)) ** (GAMMA / (GAMMA - 1)))
    return numpy.sqrt(2 * GAMMA / (GAMMA - 1) * (r ** (2 / GAMMA) - r ** ((GAMMA + 1) / GAMMA)))


def orifice(area, p_a, t_a, p_b, t_b):
    if p_a < p_b:
        return -orifice(area, p_b, t_b, p_a, t_a)
    return area * p_a / numpy.sqrt(R * t_a) * flow_function(p_b / p_a)


def mean_pressure(a, b):
    return 2 / 3 * (a * a + a * b + b * b) / (a + b)


class Pack:
    """Right-hand side with rings on a flank (-1 lower, 1 upper) or free (0)."""

    def __init__(self, omega, moves):
        self.omega, self.moves, self.at = omega, moves, [-1, -1]

    def degrees(self, t):
        return numpy.degrees(self.omega * t)

    def chamber(self, t):
        return numpy.interp(self.degrees(t) % 720, ANGLE, PRESSURE)

    def velocity(self, t):
        s, c = numpy.sin(self.omega * t), numpy.cos(self.omega * t)
        return -CRANK * self.omega * s * (1 + CRANK * c / numpy.sqrt(ROD**2 - (CRANK * s) ** 2))

    def piston_acceleration(self, t):
        step = 1e-4 / self.omega
        return (self.velocity(t + step) - self.velocity(t - step)) / (2 * step)

    def clearance_flow(self, clearance, ring, p_a, p_b):
        if clearance <= 0 or p_a == p_b:
            return 0.0
        length, width = numpy.pi * (OUTER + INNER) / 2, (OUTER - INNER) / 2
        t = TEMPERATURE[2 * ring]
        m = (p_a**2 - p_b**2) * clearance**3 * length / (24 * MU * R * t * width)
        if self.moves:
            m /= numpy.sqrt(1 + (m / orifice(length * clearance, p_a, t, p_b, t)) ** 2)
        return m

    def acceleration(self, ring, t, y):
        p = y[:4] * RT_V
        above, groove, below = (self.chamber(t), p[1])[ring], p[2 * ring], p[2 * ring + 1]
        edge, flank = numpy.pi / 4 * (BORE**2 - OUTER**2), numpy.pi / 4 * (OUTER**2 - INNER**2)
        force = edge * (below - above) + flank * (mean_pressure(groove, below) - mean_pressure(above, groove))
        on_bore = numpy.pi * BORE * WIDTH[ring] * (P_E + groove - P_CRANKCASE)
        force -= FRICTION * on_bore * numpy.tanh(self.velocity(t) / U_0)
        return force / MASS[ring] - self.piston_acceleration(t)

    def rates(self, t, y):
        p, dy = y[:4] * RT_V, numpy.zeros(9)
        above, t_above = (self.chamber(t), p[1]), (T_CHAMBER, TEMPERATURE[1])
        for ring in (0, 1):
            z, groove, below = y[4 + 2 * ring], 2 * ring, 2 * ring + 1
            gap = orifice(C * GAP, above[ring], t_above[ring], p[below], TEMPERATURE[below])
            upper = self.clearance_flow(CLEARANCE - z, ring, above[ring], p[groove])
            lower = self.clearance_flow(z, ring, p[groove], p[below]) if self.moves else 0.0
            dy[groove] += upper - lower
            dy[below] += gap + lower
            if ring == 1:
                dy[1] -= gap + upper
            if self.at[ring] == 0:
                dy[4 + 2 * ring], dy[5 + 2 * ring] = y[5 + 2 * ring], self.acceleration(ring, t, y)
        dy[8] = orifice(C * OIL_GAP, p[3], TEMPERATURE[3], P_CRANKCASE, 360.0)
        dy[3] -= dy[8]
        return dy

    def watched(self):
        """Functions that end a step where they rise through zero, with ring and flank."""
        events = []

        def watch(function, ring, flank):
            function.terminal, function.direction = True, 1
            events.append((function, ring, flank))

        for ring in (0, 1) if self.moves else ():
            at = self.at[ring]
            if at != 0:
                watch(lambda t, y, ring=ring, at=at: -at * self.acceleration(ring, t, y), ring, at)
            else:
                watch(lambda t, y, ring=ring: -y[4 + 2 * ring] / CLEARANCE - 1e-9, ring, -1)
                watch(lambda t, y, ring=ring: y[4 + 2 * ring] / CLEARANCE - 1 - 1e-9, ring, 1)
        return events


def run(speed_rpm, moves, n_cycles):
    omega = speed_rpm * numpy.pi / 30
    pack, cycle = Pack(omega, moves), 4 * numpy.pi / omega
    y, t = numpy.concatenate([P_CRANKCASE / RT_V, numpy.zeros(5)]), 0.0
    tolerance = numpy.concatenate([1e-9 * P_CRANKCASE / RT_V, [1e-12, 1e-8] * 2, [1e-17]])
    names = {-1: "lower", 1: "upper"}
    for n in range(1, n_cycles + 1):
        events, peak, place, y[8] = [], numpy.zeros(4), numpy.zeros(4), 0.0
        while t < n * cycle * (1 - 1e-14):
            for ring in (0, 1) if moves else ():
                if pack.at[ring] != 0 and -pack.at[ring] * pack.acceleration(ring, t, y) > 0:
                    events.append((pack.degrees(t) % 720, ring + 1, "leaves-" + names[pack.at[ring]]))
                    pack.at[ring] = 0
            watched = pack.watched()
            done = solve_ivp(
                pack.rates,
                (t, n * cycle),
                y,
                method="Radau",
                rtol=1e-7,
                atol=tolerance,
                events=[function for function, _, _ in watched] or None,
                max_step=cycle / 1440,
            )
            p = done.y[:4] * RT_V[:, None]
            for i in range(4):
                k = p[i].argmax()
                if p[i, k] > peak[i]:
                    peak[i], place[i] = p[i, k], pack.degrees(done.t[k]) % 720
            t, y = done.t[-1], done.y[:, -1].copy()
            for (_, ring, flank), times in zip(watched, done.t_events or []):
                if done.status != 1 or len(times) == 0:
                    continue
                kind = "lands-" if pack.at[ring] == 0 else "leaves-"
                events.append((pack.degrees(times[0]) % 720, ring + 1, kind + names[flank]))
                pack.at[ring] = flank if kind == "lands-" else 0
                y[4 + 2 * ring], y[5 + 2 * ring] = (0.0 if flank < 0 else CLEARANCE), 0.0
        print(f"cycle {n}: blow-by {y[8]:.8g} kg, peaks {peak} Pa at {place}", flush=True)
    for angle, ring, event in sorted(events):
        print(f"{angle:9.4f} ring {ring} {event}")


if __name__ == "__main__":
    run(float(sys.argv[1]), sys.argv[2] == "axial", int(sys.argv[3]) if len(sys.argv) > 3 else 8)
