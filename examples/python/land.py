"""Lift and friction of a flat land, a rail of an oil ring, on a rough liner. The map of the liner is SYNTHETIC."""

import pathlib

from ringfilm import surface

MEASURED = pathlib.Path(__file__).resolve().parents[2] / "cases" / "measured"

liner = surface.read(MEASURED / "liner.sur")
heights = surface.prepare(liner.heights, liner.step, short_cutoff=1e-6, long_cutoff=20e-6)
land = surface.land_film(
    heights,
    liner.step,
    separations=[1.2e-6, 1.6e-6, 2e-6],  # of the mean planes [m]
    width=30e-6,  # [m]
    speed=8.0,  # [m/s]
    viscosity=6e-3,  # [Pa s]
    cavitation_pressure=1e5,  # gas comes out of the oil at 1 bar, ASSUMED [Pa]
    patches=1,
)

for separation, lift, stress in zip(land["separation"], land["lift"], land["friction_stress"]):
    print(f"{1e6 * separation:.1f} um: lift {1e-3 * lift:.1f} kPa, shear stress {1e-3 * stress:.1f} kPa")
