"""Contact table of two maps, elastic and with a hardness, next to Greenwood and Tripp. Both maps are SYNTHETIC."""

import pathlib

import numpy
from ringfilm import laws, surface

MEASURED = pathlib.Path(__file__).resolve().parents[2] / "cases" / "measured"

E_prime = laws.composite_modulus(203e9, 0.3, 92.3e9, 0.3)  # steel and grey iron, ASSUMED [Pa]
maps = [surface.read(MEASURED / name) for name in ("ring_new.x3p", "liner.sur")]
step = maps[0].step
ring, liner = (surface.prepare(one.heights, step, short_cutoff=1e-6, long_cutoff=80e-6) for one in maps)
measures = [surface.surface_measures(heights, step) for heights in (ring, liner)]
pair = surface.pair_parameters(*measures, rule="rq")

separations = numpy.array([1.0e-6, 1.5e-6, 2.0e-6])  # of the mean planes [m]
elastic = surface.contact_law(ring, step, separations, E_prime, second=liner)["contact_pressure"]
capped = surface.contact_law(ring, step, separations, E_prime, second=liner, hardness=2.5e9)["contact_pressure"]
closed = laws.GreenwoodTripp(pair.density_per_m2, pair.beta_m, pair.sigma_m, E_prime).pressure(separations)

print("separation: elastic, with a hardness of 2.5 GPa (ASSUMED), Greenwood and Tripp")
for row in zip(1e6 * separations, 1e-6 * elastic, 1e-6 * capped, 1e-6 * closed):
    print("{:.1f} um: {:.3g} MPa, {:.3g} MPa, {:.3g} MPa".format(*row))
