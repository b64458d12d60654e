# Written by script/python-stubs; do not edit.
"""From a trace over a ring face to its shape; see ringfilm.face."""

from typing import *

import numpy
from . import Case


class FaceFit:
    """The shape of a ring face; its arrays are read-only. Source: docs/theory/face.md."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def averaged(self) -> object:
        """Neighbouring points of the trace that were averaged into one."""
        ...
    @property
    def coefficients(self) -> object:
        """Of the polynomial, height in um of x in mm, highest power first, as ring.face.coefficients has them; shape (degree + 1,), read-only."""
        ...
    @property
    def gap_m(self) -> object:
        """Gap of the trace, levelled and aligned, shape (x,) [m]."""
        ...
    def height(self, x: numpy.ndarray) -> object:
        """Height of the polynomial at x, any shape [m]. Raises InputError."""
        ...
    @property
    def invented(self) -> object:
        """A list of FitArtifact."""
        ...
    @property
    def noise_m(self) -> object:
        """Rms of what neither follows [m]."""
        ...
    @property
    def polynomial_end_m(self) -> object:
        """The polynomial at x = 0 and at the width, above its lowest place, (first, last) [m]."""
        ...
    @property
    def polynomial_minimum_at_m(self) -> object:
        """Lowest place of the polynomial [m]."""
        ...
    @property
    def polynomial_minimum_m(self) -> object:
        """Least gap of the polynomial, as gap_m counts [m]."""
        ...
    @property
    def polynomial_residual(self) -> object:
        """FaceResidual of the polynomial."""
        ...
    @property
    def pore_share(self) -> object:
        """Share of the points left out as pores [-]."""
        ...
    @property
    def running_surface_from_m(self) -> object:
        """Where the running surface begins [m]."""
        ...
    @property
    def running_surface_to_m(self) -> object:
        """Where it ends [m]."""
        ...
    @property
    def spline_cutoff_m(self) -> object:
        """Its stiffness [m]."""
        ...
    @property
    def spline_end_m(self) -> object:
        """The same of the spline, (first, last) [m]."""
        ...
    @property
    def spline_m(self) -> object:
        """Spline at x_m, shape (x,) [m]."""
        ...
    @property
    def spline_minimum_at_m(self) -> object:
        """Lowest place of the spline [m]."""
        ...
    @property
    def spline_minimum_m(self) -> object:
        """Least gap of the spline, as gap_m counts [m]."""
        ...
    @property
    def spline_residual(self) -> object:
        """FaceResidual of the spline."""
        ...
    @property
    def start_m(self) -> object:
        """Place in the trace that became x = 0 [m]."""
        ...
    @property
    def tilt(self) -> object:
        """Taken off [-]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...
    @property
    def x_m(self) -> object:
        """Places from 0 to the width, shape (x,) [m]."""
        ...

class FaceResidual:
    """Trace less fit."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def largest_at_m(self) -> object:
        """Where it is [m]."""
        ...
    @property
    def largest_m(self) -> object:
        """The largest [m]."""
        ...
    @property
    def rms_m(self) -> object:
        """Rms [m]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class FitArtifact:
    """Where the polynomial has what the trace has not."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def from_m(self) -> object:
        """Begin [m]."""
        ...
    @property
    def reason(self) -> object:
        """What gives it away: "departs" from the trace, "turn-not-in-trace", "falls-towards-the-edge"."""
        ...
    @property
    def size_m(self) -> object:
        """Largest distance, or fall [m]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...
    @property
    def to_m(self) -> object:
        """End [m]."""
        ...
    def words(self) -> str:
        """The same as a sentence."""
        ...

def fit_face(x: numpy.ndarray, height: numpy.ndarray, width: float, sense: str = 'material', start: Optional[float] = None, direction: str = 'as-measured', levelling: str = 'running-surface', tilt: float = 0.0, zero: str = 'lowest-point', running_surface_height: float = 1e-06, pore_depth: Optional[float] = None, spline_cutoff: Optional[float] = None, degree: int = 6) -> FaceFit:
    """The shape of a ring face from a trace over it: polynomial and spline, both with what they leave.

    x, height: places and heights of the trace, shape (points,) [m]. width: of the face [m].
    sense: "material" (heights away from the ring, as a stylus has them) or "gap". start: where the face begins in the
    trace [m]; None: where its mean gap is least. direction: "as-measured", "turned". levelling: "running-surface", "stated"
    with its tilt [-], "none". zero: "lowest-point", "as-measured". running_surface_height, pore_depth, spline_cutoff [m];
    degree of the polynomial. Returns a FaceFit. Raises InputError, for NaN and masked points too, and TypeError.
    Source: docs/theory/face.md."""
    ...

def read_trace(path: object, height_unit: Optional[str] = None, lateral_unit: Optional[str] = None, step: Optional[str] = None) -> tuple:
    """Places and heights of a trace, two arrays of shape (points,) [m], from a file of any known format.

    height_unit, lateral_unit: "um"; step: "0.5 um", where the file does not say. Raises InputError, TypeError."""
    ...
