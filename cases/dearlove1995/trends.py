#!/usr/bin/env python3
"""Computes the study of trends.toml and compares it, at mid-stroke, with the ranges and trends of dearlove1995.

usage: trends.py             (requires the Python module ringfilm); prints the tables of docs/manual/guide/rig-trends.md
       trends.py supply      the same for supply.toml: gas at both edges and a given film of oil on the liner
"""

import itertools
import pathlib
import sys

import numpy
import ringfilm

STUDY = pathlib.Path(__file__).resolve().with_name("trends.toml")
SUPPLY = STUDY.with_name("supply.toml")
PUBLISHED_FILM = (0.5e-6, 4e-6)  # [m], dearlove1995, mid-stroke
PUBLISHED_COEFFICIENT = (0.02, 0.1)  # dearlove1995, mid-stroke

# Axes of all arrays below, in the order of the factors of trends.toml.
VISCOSITY, SPEED, LOAD, ROUGHNESS, CROWN = range(5)
FACTORS = ("factor_viscosity", "factor_speed", "factor_ring_load", "factor_roughness", "factor_crown_height")


class Trends:
    """The values at mid-stroke, over (viscosity, speed, ring load, roughness, crown height).

    film [m]; coefficient: friction over ring load, without the air, which presses from both sides; boundary_share of
    the friction. Along the axes: viscosities [Pa s], speeds [m/s] (means of the piston), loads [Pa], roughnesses [m],
    crowns [m].
    """

    def __init__(self, data, case):
        axes = [numpy.unique(data[name]) for name in FACTORS]
        viscosity = case["lubricant.density"] * case["lubricant.kinematic_viscosity"][0][1]
        self.viscosities = axes[VISCOSITY] * viscosity
        self.speeds = axes[SPEED] * case["engine.stroke"] / numpy.pi
        self.loads, self.roughnesses, self.crowns = axes[LOAD:]

        position = data["curve_piston_position"].values[0, :, 0] - case["engine.stroke"] / 2
        before = numpy.nonzero(numpy.diff(numpy.sign(position)))[0]  # the passages of mid-stroke lie behind these
        share = position[before] / (position[before] - position[before + 1])

        def at_mid_stroke(name):
            curves = data[f"curve_{name}"].values[:, :, 0].astype(float)
            passages = curves[:, before] + share * (curves[:, before + 1] - curves[:, before])
            return passages.mean(axis=1).reshape([len(axis) for axis in axes])

        area = numpy.pi * case["engine.bore"] * case["ring.face_width"]
        friction = at_mid_stroke("total_friction")
        self.film = at_mid_stroke("min_film_thickness")
        self.coefficient = friction / (area * self.loads[:, None, None])
        self.boundary_share = at_mid_stroke("boundary_friction") / friction

    def rises_with_load(self):
        """Does the coefficient rise from each load to the next?"""
        return numpy.diff(self.coefficient, axis=LOAD) > 0

    def falls_with_speed(self):
        """Does the coefficient fall from each speed to the next?"""
        return numpy.diff(self.coefficient, axis=SPEED) < 0


def run(study):
    """The results of all scenarios of a study, and its case."""
    data = ringfilm.Study.read(study).run().to_xarray()
    if not data["solved"].all():
        raise RuntimeError(f"a scenario of {study.name} was not solved")
    return data, ringfilm.Case.read(study.with_name("rig.toml"))


def compute():
    return Trends(*run(STUDY))


def compute_supplies(study=SUPPLY):
    """The trends of each film of oil on the liner [m] of supply.toml."""
    data, case = run(study)
    film = data["factor_oil_on_the_liner"].values
    return {given: Trends(data.isel(scenario=film == given), case) for given in numpy.unique(film)}


def inside(values, limits):
    return (limits[0] <= values) & (values <= limits[1])


def table(head, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows])


def count(values):
    return f"{values.sum()} of {values.size}"


def tables(trends):
    """Two tables as Markdown: ranges and trends of each pair and face, and the trends oil by oil."""
    load, speed = trends.rises_with_load(), trends.falls_with_speed()
    ranges, oils = [], []
    for i, k in itertools.product(range(len(trends.roughnesses)), range(len(trends.crowns))):
        film, coefficient = trends.film[..., i, k], trends.coefficient[..., i, k]
        label = [f"{1e6 * trends.roughnesses[i]:.1f} µm", f"{1e6 * trends.crowns[k]:.0f} µm"]
        ranges.append(
            [
                *label,
                f"{1e6 * film.min():.2f} to {1e6 * film.max():.1f} µm",
                count(inside(film, PUBLISHED_FILM)),
                f"{coefficient.min():.3f} to {coefficient.max():.3f}",
                count(inside(coefficient, PUBLISHED_COEFFICIENT)),
                count(load[..., i, k]),
                count(speed[..., i, k]),
            ]
        )
        met = [numpy.append(load[n, ..., i, k], speed[n, ..., i, k]) for n in range(len(trends.viscosities))]
        oils.append([*label, *map(count, met)])
    head = ["roughness", "crown height"]
    return (
        table([*head, "film", "within", "coefficient", "within", "rises with load", "falls with speed"], ranges),
        table([*head, *(f"{1e3 * viscosity:.0f} mPa s" for viscosity in trends.viscosities)], oils),
    )


def supply_rows(trends, label):
    """A row for each roughness, over all oils, speeds, loads and crown heights."""
    load, speed = trends.rises_with_load(), trends.falls_with_speed()
    rows = []
    for i, roughness in enumerate(trends.roughnesses):
        film, coefficient = trends.film[..., i, :], trends.coefficient[..., i, :]
        rings = load[..., i, :].all(axis=(0, 1, 2)) & speed[..., i, :].all(axis=(0, 1, 2))
        rows.append(
            [
                f"{1e6 * roughness:.1f} µm",
                label,
                f"{1e6 * film.min():.2f} to {1e6 * film.max():.1f} µm",
                count(inside(film, PUBLISHED_FILM)),
                count(inside(coefficient, PUBLISHED_COEFFICIENT)),
                count(load[..., i, :]),
                count(speed[..., i, :]),
                count(rings),
            ]
        )
    return rows


def supply_table(supplies):
    """As Markdown: ranges and trends of each roughness with each film of oil on the liner."""
    rows = itertools.chain(*(supply_rows(trends, f"{1e6 * given:.0f} µm") for given, trends in supplies.items()))
    head = ["roughness", "oil on the liner", "film", "film within", "coefficient within", "rises with load"]
    # Stable: films of oil keep their order within a roughness.
    return table([*head, "falls with speed", "rings with all trends"], sorted(rows, key=lambda row: row[0]))


if __name__ == "__main__":
    print(supply_table(compute_supplies()) if sys.argv[1:] == ["supply"] else "\n\n".join(tables(compute())))
