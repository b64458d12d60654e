# Written by script/python-stubs; do not edit.
"""Friction loops; see ringfilm.lateral_force."""

from typing import *

import numpy
from . import Case


class Calibration:
    """The factor psi of zeta = psi m."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def degrees_of_freedom(self) -> object:
        """Of the measurement; inf where it is stated."""
        ...
    @property
    def load_unit(self) -> object:
        """Unit of the loads, "V" or "N"."""
        ...
    @property
    def measurement_deviation(self) -> object:
        """Of psi, from its own lines."""
        ...
    @property
    def method(self) -> object:
        """"silicon", "geometry" or "wedge"."""
        ...
    @property
    def psi(self) -> object:
        """[-] for loads in volts, [N/V] for loads in newtons."""
        ...
    @property
    def reference_deviation(self) -> object:
        """Of psi, from what was taken over."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class ForceSample:
    """Loops of one sample and the line through them."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def line(self) -> object:
        """LineFit of friction signal against load."""
        ...
    @property
    def load_unit(self) -> object:
        """Unit of the loads, "V" or "N"."""
        ...
    @property
    def loads(self) -> object:
        """A list of LoadFriction, rising."""
        ...
    @property
    def name(self) -> object:
        """As the file has it."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class LineFit:
    """y = offset + slope x. Source: York (2004), docs/theory, eq-line-weights."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def chi_squared(self) -> object:
        """Weighted squares about the line."""
        ...
    @property
    def chi_squared_probability(self) -> object:
        """That stated deviations alone give as much or more [-]; below 0.01 they are too small, or the line is none."""
        ...
    @property
    def covariance(self) -> object:
        """Of slope and offset."""
        ...
    @property
    def deviations(self) -> object:
        """What the deviations of the points meant, "stated" or "from-residuals"."""
        ...
    @property
    def offset(self) -> object:
        """Value at 0 [y]."""
        ...
    @property
    def offset_deviation(self) -> object:
        """Standard error of the offset."""
        ...
    @property
    def points(self) -> object:
        """How many points."""
        ...
    @property
    def slope(self) -> object:
        """Slope [y/x]."""
        ...
    @property
    def slope_deviation(self) -> object:
        """Standard error of the slope."""
        ...
    def slope_half_width(self, confidence: float) -> float:
        """Half the width of the interval that holds the slope with this probability, between 0 and 1 [-]. Raises InputError."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class LoadFriction:
    """All loops of one load."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def load(self) -> object:
        """[V] or [N]."""
        ...
    @property
    def load_deviation(self) -> object:
        """Standard deviation of the load [V] or [N]; 0: exact."""
        ...
    @property
    def loops(self) -> object:
        """How many."""
        ...
    @property
    def offset_V(self) -> object:
        """Mean of half of trace plus retrace [V]."""
        ...
    @property
    def offset_deviation_V(self) -> object:
        """Its standard error [V]; 0: not known."""
        ...
    @property
    def tmr_V(self) -> object:
        """Mean friction signal [V]."""
        ...
    @property
    def tmr_deviation_V(self) -> object:
        """Standard error of the mean [V]; 0: not known."""
        ...
    @property
    def tmr_scatter_V(self) -> object:
        """Between the loops of this load [V]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class LoopFriction:
    """A friction loop without its ends. Source: eq-friction-loop."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def offset_V(self) -> object:
        """Half of trace plus retrace [V]."""
        ...
    @property
    def offset_deviation_V(self) -> object:
        """Its standard error [V]."""
        ...
    @property
    def points(self) -> object:
        """Positions that were kept."""
        ...
    @property
    def tmr_V(self) -> object:
        """Half of trace minus retrace [V]."""
        ...
    @property
    def tmr_deviation_V(self) -> object:
        """Its standard error [V]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

class ShearStrength:
    """zeta of one sample. Source: eq-zeta, eq-zeta-shares."""
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @property
    def calibration_deviation(self) -> object:
        """From the measurement of psi [-]."""
        ...
    def deviation(self) -> float:
        """Standard deviation, all shares together [-]."""
        ...
    @property
    def high(self) -> object:
        """Upper end [-]."""
        ...
    @property
    def low(self) -> object:
        """Lower end of the 95 % interval [-]."""
        ...
    @property
    def reference_deviation(self) -> object:
        """From the value taken over for psi [-]."""
        ...
    @property
    def sample(self) -> object:
        """Its name."""
        ...
    @property
    def slope_deviation(self) -> object:
        """From the sample's own line [-]."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...
    @property
    def zeta(self) -> object:
        """Coefficient of boundary shear strength [-]."""
        ...

def boundary_shear_strengths(samples: List[ForceSample], calibration: Calibration) -> tuple:
    """Coefficients of boundary shear strength of samples that share a calibration.

    Returns (list of ShearStrength, covariance of zeta of shape (samples, samples)). Raises InputError, for a sample with
    the line that the calibration follows from, too.
    Source: eq-zeta, eq-zeta-covariance."""
    ...

def calibrate_on_silicon(silicon: LineFit, load_unit: str, reference: Optional[Tuple[float, float]] = None) -> Calibration:
    """psi from the line of silicon. load_unit: "V" or "N". reference: (coefficient of friction, its deviation);
    None: 0.19, 0.1 after Ahimou et al. (2007). Returns a Calibration. Raises InputError. Source: eq-psi-silicon."""
    ...

def fit_line(x: numpy.ndarray, y: numpy.ndarray, x_deviation: numpy.ndarray = 0.0, y_deviation: numpy.ndarray = 1.0, deviations: str = 'from-residuals') -> LineFit:
    """A straight line through points that are uncertain in both directions, by weighted total least squares.

    x, y: shape (points,) [any unit]. x_deviation, y_deviation: standard deviations, one for all or one a point;
    "from-residuals" takes only their ratios for known, "stated" themselves. Returns a LineFit. Raises InputError.
    Source: York (2004)."""
    ...

def loop_friction(position: numpy.ndarray, trace: numpy.ndarray, retrace: numpy.ndarray, end_share: float = 0.1) -> LoopFriction:
    """Friction signal of one loop.

    position [m], trace and retrace [V]: shape (points,), both ways at the same positions, rising. end_share: of the length,
    cut off at each end [-]. Returns a LoopFriction. Raises InputError, for NaN and masked values too, and TypeError.
    Source: docs/theory, eq-friction-loop."""
    ...

def read(*args, end_share: float = 0.1, deviations: str = 'from-residuals', load_deviation: Optional[str] = None) -> List[ForceSample]:
    """Samples of CSV files of friction loops (docs/manual/lateral-force.md); several paths may be named.

    end_share: of the scan length, cut off at each end [-]. deviations: "from-residuals" or "stated"; load_deviation: of
    each load, "0.5 nN". Returns a list of ForceSample. Raises InputError with the faults of all files."""
    ...
