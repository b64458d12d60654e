"""Films and gas of a ring pack that shares the oil on the liner. Rings and oil: ASSUMED, pressure: SYNTHETIC."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

pack = ringfilm.Case.read(CASES / "ring-pack" / "three_rings.toml").run()
for ring in pack.by_ring:
    print(f"ring {ring['ring']}: {ring['fmep'] / 1e3:.2f} kPa, {ring['mean_power_loss']:.1f} W")
print(f"pack: {pack.fmep / 1e3:.2f} kPa, blow-by {60e3 * pack.gas['blow_by_flow']:.2f} l/min per cylinder")
