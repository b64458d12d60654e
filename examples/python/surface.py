"""Roughness of a ring and its liner, and the asperities of the pair. Both maps are SYNTHETIC."""

import pathlib

from ringfilm import surface

MEASURED = pathlib.Path(__file__).resolve().parents[2] / "cases" / "measured"

measures = []
for name in ("ring_new.x3p", "liner.sur"):
    measured = surface.read(MEASURED / name)
    heights = surface.prepare(measured.heights, measured.step, short_cutoff=1e-6, long_cutoff=80e-6)
    measures.append(surface.surface_measures(heights, measured.step))
    Sq = surface.height_statistics(heights, measured.step).Sq_m
    core = surface.core_roughness(surface.material_ratio_curve(heights, measured.step))
    print(f"{name}: Sq {1e6 * Sq:.3f} um, Spk {1e6 * core.Rpk_m:.3f} um, Svk {1e6 * core.Rvk_m:.3f} um")

pair = surface.pair_parameters(*measures)
print(f"asperity density {1e-12 * pair.density_per_m2:.3f} um-2, radius {1e6 * pair.beta_m:.2f} um")
print(f"composite roughness {1e6 * pair.sigma_m:.3f} um")
