"""Friction, film and roughness of a ring over its running hours, between three measured states."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

life = ringfilm.run_life(CASES / "life" / "styles2014.toml")
for state in life["states"]:
    if state["hours"] in (0, 3, 10, 30, 150):
        print(
            f"{state['hours']:3.0f} h ({state['state_origin']}): {state['fmep'] / 1e3:.2f} kPa, "
            f"film {1e6 * state['min_film_thickness']:.2f} um, roughness {1e6 * state['roughness']:.2f} um"
        )
