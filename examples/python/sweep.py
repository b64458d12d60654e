"""Friction and film of a ring over engine speed. The cylinder pressure is SYNTHETIC and the same at all speeds."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

case = ringfilm.Case.read(CASES / "styles2014" / "new.toml")
speeds = [1000, 2000, 3000, 4000, 5000]  # [rpm]
cases = [case.copy(operating__speed=f"{speed} rpm") for speed in speeds]
batch = ringfilm.simulate_many(cases, curves="none")

for speed, fmep, film in zip(speeds, batch["fmep"], batch["min_film_thickness"]):
    print(f"{speed} rpm: {fmep / 1e3:.2f} kPa, minimum film thickness {1e6 * film:.3f} um")
