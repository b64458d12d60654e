"""Analysis of measured heights: form, filters, roughness, asperities (docs/theory/surface.md).

Heights are arrays of shape (y, x), or (x,) for a profile, in metres away from the material; NaN, or masked in an array
of numpy.ma, where nothing was measured. A step is the distance of two points, one number or (step_x, step_y) [m]. What
is not an array of real numbers, or not a number, is a TypeError; values that mean nothing are an InputError.
"""

from typing import Optional

from ._ringfilm.surface import (
    AsperityParameters,
    Cavities,
    CoreRoughness,
    HeightStatistics,
    MeasuredMap,
    ProbabilityRoughness,
    RowRoughness,
    SampledHeights,
    SpectralMoments,
    Summits,
    SummitTheory,
    SurfaceMeasures,
    _prepare,
    asperity_parameters,
    contact_law,
    material_ratio_curve,
    cavities,
    core_roughness,
    count_summits,
    gaussian_transmission,
    height_statistics,
    land_film,
    moments,
    moments_of,
    pair_parameters,
    probability_roughness,
    read,
    row_roughness,
    sampled_heights,
    single_parameters,
    summit_theory,
    surface_measures,
)


def prepare(
    heights,
    step,
    form: str = "tilt",
    degree: int = 2,
    short_cutoff: Optional[float] = None,
    long_cutoff: Optional[float] = None,
    filter: str = "gaussian",
):
    """What happens between the instrument and the statistics, in this order: form, short cut-off, long cut-off.

    heights: shape (y, x) or (x,) [m]; NaN or masked where nothing was measured. step: [m].
    form: "none", "mean", "tilt", "cylinder", or "polynomial" with its degree. short_cutoff, long_cutoff: nesting
    indices of the S- and the L-filter [m]. filter: "gaussian" (ISO 16610-21, -61), "robust-gaussian" (-31, -71)
    or, of profiles, "valley-suppression" (ISO 13565-1).

    Returns new heights of the same shape, NaN where nothing was measured. Raises InputError, TypeError.
    Source: docs/theory, eq-surface-form, eq-surface-gaussian.
    """
    return _prepare(heights, step, form, degree, short_cutoff, long_cutoff, filter)[0]


def preparation_lines(
    heights,
    step,
    form: str = "tilt",
    degree: int = 2,
    short_cutoff: Optional[float] = None,
    long_cutoff: Optional[float] = None,
    filter: str = "gaussian",
) -> list:
    """What prepare() removes with the same arguments, a sentence a step, for records. Raises InputError."""
    return _prepare(heights, step, form, degree, short_cutoff, long_cutoff, filter)[1]


__all__ = [
    "AsperityParameters",
    "Cavities",
    "CoreRoughness",
    "HeightStatistics",
    "MeasuredMap",
    "ProbabilityRoughness",
    "RowRoughness",
    "SampledHeights",
    "SpectralMoments",
    "SummitTheory",
    "Summits",
    "SurfaceMeasures",
    "asperity_parameters",
    "contact_law",
    "material_ratio_curve",
    "cavities",
    "core_roughness",
    "count_summits",
    "gaussian_transmission",
    "height_statistics",
    "land_film",
    "moments",
    "moments_of",
    "pair_parameters",
    "preparation_lines",
    "prepare",
    "probability_roughness",
    "read",
    "row_roughness",
    "sampled_heights",
    "single_parameters",
    "summit_theory",
    "surface_measures",
]
