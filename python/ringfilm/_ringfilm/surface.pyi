# Written by script/python-stubs; do not edit.
"""Analysis of measured heights; see ringfilm.surface."""

from typing import *

import numpy
from . import Case


class AsperityParameters:
    """What a contact model takes. Source: docs/theory/surface.md."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def beta_m(self) -> object:
        """Mean summit radius [m]."""
        ...
    @property
    def density_per_m2(self) -> object:
        """N [1/m2]."""
        ...
    def roughness_parameter(self) -> float:
        """N beta sigma [-]."""
        ...
    @property
    def sigma_m(self) -> object:
        """Composite roughness [m]."""
        ...
    def slope(self) -> float:
        """sigma/beta [-]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class Cavities:
    """Pores and grooves. Source: docs/theory, eq-surface-cavities."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def area_share(self) -> object:
        """Of the measured points [-]."""
        ...
    @property
    def mean_depth_m(self) -> object:
        """Mean depth below the median [m]."""
        ...
    @property
    def threshold_m(self) -> object:
        """Height below which a point counts [m]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...
    @property
    def volume_m(self) -> object:
        """Volume for each nominal area [m]."""
        ...

class CoreRoughness:
    """Core, peaks and valleys after ISO 13565-2."""
    @property
    def Mr1(self) -> object:
        """Material ratio where the core begins [-]."""
        ...
    @property
    def Mr2(self) -> object:
        """Material ratio where it ends [-]."""
        ...
    @property
    def Rk_m(self) -> object:
        """Core roughness [m]."""
        ...
    @property
    def Rpk_m(self) -> object:
        """Reduced peaks [m]."""
        ...
    @property
    def Rvk_m(self) -> object:
        """Reduced valleys [m]."""
        ...
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def lower_m(self) -> object:
        """Height of the core's line at 1 [m]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...
    @property
    def upper_m(self) -> object:
        """Height of the core's line at 0 [m]."""
        ...

class HeightStatistics:
    """Height statistics; Ra, Rq, ... of a profile. Source: docs/theory, eq-surface-heights."""
    @property
    def Sa_m(self) -> object:
        """Mean absolute deviation [m]."""
        ...
    @property
    def Sku(self) -> object:
        """Kurtosis [-], 3 for a Gaussian."""
        ...
    @property
    def Sp_m(self) -> object:
        """Highest peak above the mean [m]."""
        ...
    @property
    def Sq_m(self) -> object:
        """Rms deviation [m]."""
        ...
    @property
    def Ssk(self) -> object:
        """Skewness [-]."""
        ...
    @property
    def Sv_m(self) -> object:
        """Deepest pit below the mean [m], positive."""
        ...
    @property
    def Sz_m(self) -> object:
        """Peak to pit [m]."""
        ...
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def mean_m(self) -> object:
        """Mean height [m]."""
        ...
    @property
    def missing(self) -> object:
        """Points without a height."""
        ...
    @property
    def points(self) -> object:
        """Measured points."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class MeasuredMap:
    """A map of heights as an instrument's file gave it."""
    def __eq__(self, other: object) -> object:
        """Are the heights and all that is reported of them the same? Points that were not measured are."""
        ...
    def __repr__(self) -> str:
        """The plausibility line."""
        ...
    @property
    def format(self) -> object:
        """Format of the file."""
        ...
    @property
    def heights(self) -> object:
        """Shape (y, x), of a profile (x,) [m]; NaN where nothing was measured. Read-only: .copy() for an array to work on."""
        ...
    @property
    def notes(self) -> object:
        """What is odd about the file."""
        ...
    @property
    def plausibility(self) -> object:
        """A line that says whether the map can be what one thinks it is."""
        ...
    @property
    def sha256(self) -> object:
        """Digest of the file."""
        ...
    @property
    def step(self) -> object:
        """Between the points along x and y [m], as every function here takes it."""
        ...

class ProbabilityRoughness:
    """A surface made in two steps, after ISO 13565-3."""
    @property
    def Rmq(self) -> object:
        """Material ratio where both meet [-]."""
        ...
    @property
    def Rpq_m(self) -> object:
        """Rms of the plateau [m]."""
        ...
    @property
    def Rvq_m(self) -> object:
        """Rms of the valleys [m]."""
        ...
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class RowRoughness:
    """Roughness of the rows of a map, each about its own mean."""
    @property
    def Ra_m(self) -> object:
        """Mean of Ra [m]."""
        ...
    @property
    def Rq_m(self) -> object:
        """Root of the mean square of Rq [m]."""
        ...
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def rows(self) -> object:
        """Rows that had enough points."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class SpectralMoments:
    """Variances of heights, slopes, curvatures. Source: eq-surface-moments."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __init__(self, m0_m2: float, m2: float, m4_per_m2: float) -> None:
        """From three numbers from 0 on [m2, -, 1/m2]. Raises InputError."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def m0_m2(self) -> object:
        """Of heights [m2]."""
        ...
    @property
    def m2(self) -> object:
        """Of slopes [-]."""
        ...
    @property
    def m4_per_m2(self) -> object:
        """Of curvatures [1/m2]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class SummitTheory:
    """What Gaussian isotropic surfaces should show, after Nayak (1971)."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def bandwidth(self) -> object:
        """m0 m4/m2^2 [-]."""
        ...
    @property
    def density_per_m2(self) -> object:
        """Summits per area [1/m2]."""
        ...
    @property
    def mean_curvature_per_m(self) -> object:
        """Mean curvature [1/m]."""
        ...
    @property
    def mean_height_m(self) -> object:
        """Mean height [m]."""
        ...
    @property
    def rms_height_m(self) -> object:
        """Rms height about it [m]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class Summits:
    """Summits counted one by one. Source: docs/theory, eq-summits."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def count(self) -> object:
        """How many."""
        ...
    @property
    def density_per_m2(self) -> object:
        """Per area [1/m2]."""
        ...
    @property
    def mean_curvature_per_m(self) -> object:
        """Mean curvature [1/m]."""
        ...
    @property
    def mean_height_m(self) -> object:
        """Above the mean of the map [m]."""
        ...
    @property
    def mean_radius_m(self) -> object:
        """1/mean curvature [m]."""
        ...
    @property
    def rms_height_m(self) -> object:
        """Of the summits about their own mean [m]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class SurfaceMeasures:
    """What one surface brings into a pair."""
    @property
    def Sa_m(self) -> object:
        """Mean absolute deviation [m]."""
        ...
    @property
    def Sq_m(self) -> object:
        """Rms deviation [m]."""
        ...
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __init__(self, Sa_m: float, Sq_m: float, moments: SpectralMoments) -> None:
        """From lengths from 0 on [m] and SpectralMoments. Raises InputError."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def moments(self) -> object:
        """Its SpectralMoments."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

def _prepare(heights: numpy.ndarray, step: Union[float, Tuple[float, float]], form: str, degree: int, short_cutoff: Optional[float], long_cutoff: Optional[float], filter: str) -> tuple:
    """See ringfilm.surface.prepare."""
    ...

def asperity_parameters(moments: SpectralMoments, sigma: float) -> AsperityParameters:
    """N and beta of moments; sigma [m] is taken over. Raises InputError. Source: eq-asperity-density."""
    ...

def cavities(curve: numpy.ndarray, rule: str = 'below-plateau', depth: float = 0.0) -> Cavities:
    """Share of the area that are pores and grooves, of a material ratio curve of shape (points,) [m].

    rule: "below-plateau", "below-core" or "below-depth" with its depth below the median [m]. Raises InputError.
    Source: docs/theory, eq-surface-cavities."""
    ...

def core_roughness(curve: numpy.ndarray) -> CoreRoughness:
    """Rk family of a material ratio curve of shape (points,) [m]. Source: ISO 13565-2, eq-surface-core."""
    ...

def count_summits(heights: numpy.ndarray, step: Union[float, Tuple[float, float]]) -> Summits:
    """Summits of a map of shape (y, x) [m], one by one. Raises InputError for a profile. Source: eq-summits."""
    ...

def gaussian_transmission(wavelength: numpy.ndarray, cutoff: numpy.ndarray) -> object:
    """Share of the amplitude of a wave that a Gaussian S-filter lets pass [-].

    wavelength, cutoff: above 0, numbers or arrays of shapes that fit together [m]. Raises InputError.
    Source: docs/theory, eq-surface-gaussian."""
    ...

def height_statistics(heights: numpy.ndarray, step: Union[float, Tuple[float, float]]) -> HeightStatistics:
    """Height statistics of all measured points about their mean.

    heights: shape (y, x), or (x,) for a profile [m]; NaN where nothing was measured. step: a number or (x, y) [m].
    Raises InputError for fewer than 4 points or a flat surface. Source: docs/theory, eq-surface-heights."""
    ...

def material_ratio_curve(heights: numpy.ndarray, step: Union[float, Tuple[float, float]]) -> numpy.ndarray:
    """Heights of the measured points, falling, shape (points,) [m]: the material ratio curve."""
    ...

def moments(heights: numpy.ndarray, step: Union[float, Tuple[float, float]], direction: str = 'mean', scheme: str = 'neighbours') -> SpectralMoments:
    """Spectral moments of a map of shape (y, x), or of a profile (x,) along x [m].

    direction: "mean" of x and y, "geometric", "x", "y". scheme: "neighbours" or "seven-point".
    Raises InputError for fewer than 16 complete stencils. Source: docs/theory, eq-surface-moments."""
    ...

def moments_of(density: float, beta: float) -> SpectralMoments:
    """Moments that give N [1/m2] and beta [m], the inverse of asperity_parameters(); m0 stays 0. Raises InputError. Source: eq-asperity-density, eq-asperity-radius."""
    ...

def pair_parameters(first: SurfaceMeasures, second: SurfaceMeasures, rule: str = 'ra') -> AsperityParameters:
    """N, beta, sigma of two surfaces in contact. rule: "ra" or "rq", what sigma is. Raises InputError. Source: eq-asperity-pair."""
    ...

def probability_roughness(curve: numpy.ndarray) -> Optional[ProbabilityRoughness]:
    """Rpq, Rvq, Rmq of a material ratio curve [m]; None for a surface made in one step. Source: ISO 13565-3."""
    ...

def read(path: object, channel: Optional[Union[int, str]] = None, height_unit: Optional[str] = None, lateral_unit: Optional[str] = None, step_x: Optional[str] = None, step_y: Optional[str] = None) -> MeasuredMap:
    """Heights from a file of any known format (docs/manual/surface-files.md): X3P, SDF, SUR, GSF, .gwy, text.

    channel: number from 1, or name. height_unit, lateral_unit: "um"; step_x, step_y: "0.5 um", where the file does not say.
    Returns a MeasuredMap. Raises InputError with file, place, rule and remedy, and TypeError."""
    ...

def row_roughness(heights: numpy.ndarray, step: Union[float, Tuple[float, float]]) -> RowRoughness:
    """Ra and Rq of the rows of a map of shape (y, x) [m]. Raises InputError where no row has 8 measured points."""
    ...

def single_parameters(surface: SurfaceMeasures, rule: str = 'ra') -> AsperityParameters:
    """N, beta, sigma of one surface against a smooth flat. rule: "ra" or "rq", what sigma is. Raises InputError."""
    ...

def summit_theory(m0: float, m2: float, m4: float) -> SummitTheory:
    """What Gaussian isotropic surfaces of these moments should show [m2, -, 1/m2]. Raises InputError. Source: Nayak (1971), eq-nayak."""
    ...

def surface_measures(heights: numpy.ndarray, step: Union[float, Tuple[float, float]], direction: str = 'mean', scheme: str = 'neighbours') -> SurfaceMeasures:
    """What a levelled and filtered map of shape (y, x) [m] brings into a pair; words as for moments(). Raises InputError. Source: docs/theory/surface.md."""
    ...
