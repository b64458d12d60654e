# Written by script/python-stubs; do not edit.
"""Laws of contact and oil; see ringfilm.laws."""

from typing import *

import numpy
from . import Case


class GreenwoodTripp:
    """Contact of two rough surfaces after Greenwood and Tripp (1971).

    N [1/m2], beta [m], sigma [m], E_prime [Pa] of 2/E_prime = sum (1 - nu^2)/E. Source: eq-asperity-load."""
    @property
    def E_prime(self) -> object:
        """Composite modulus [Pa]."""
        ...
    @property
    def N(self) -> object:
        """Density of asperity peaks [1/m2]."""
        ...
    def __eq__(self, other: object) -> object:
        """Are all parameters the same?"""
        ...
    def __init__(self, N: float, beta: float, sigma: float, E_prime: float, integrals: str = 'exact') -> None:
        """integrals: "exact", "polynomial-4-digit", "polynomial-as-printed". Raises InputError, TypeError."""
        ...
    def __repr__(self) -> str:
        """As it would be made again."""
        ...
    def area_share(self, h: numpy.ndarray) -> object:
        """Real contact area per nominal area, any shape [m -> -]; as pressure(). Source: eq-asperity-area."""
        ...
    @property
    def beta(self) -> object:
        """Mean radius of their summits [m]."""
        ...
    @property
    def integrals(self) -> object:
        """Where the height integrals come from, as it was said."""
        ...
    def pressure(self, h: numpy.ndarray) -> object:
        """Pressure on the nominal area at the separation h, any shape [m -> Pa]. Below 0, which a solver may try on its way, it goes on along its tangent. NaN gives NaN. Raises InputError for masked values."""
        ...
    def pressure_slope(self, h: numpy.ndarray) -> object:
        """Its slope over h, any shape [m -> Pa/m]; as pressure()."""
        ...
    @property
    def sigma(self) -> object:
        """Composite roughness [m]."""
        ...

class Oil:
    """Density and viscosity of an oil at one temperature, against absolute pressure."""
    def __repr__(self) -> str:
        """Temperature, and what it is at ambient pressure."""
        ...
    def density(self, pressure: numpy.ndarray) -> object:
        """Density, any shape [Pa -> kg/m3]. Raises InputError for masked values."""
        ...
    @property
    def temperature(self) -> object:
        """Temperature of the oil [K]."""
        ...
    def viscosity(self, pressure: numpy.ndarray) -> object:
        """Dynamic viscosity, any shape [Pa -> Pa s]. Raises InputError for masked values."""
        ...

class Walther:
    """Kinematic viscosity against temperature after ASTM D341. Source: eq-walther."""
    @property
    def A(self) -> object:
        """Of log10 log10(nu + 0.7) = A - B log10 T, nu in mm2/s, T in K [-]."""
        ...
    @property
    def B(self) -> object:
        """Its fall with temperature, above 0 [-]."""
        ...
    def __eq__(self, other: object) -> object:
        """Are all members the same? A NaN is not."""
        ...
    def __repr__(self) -> str:
        """All members."""
        ...
    @staticmethod
    def fit(temperature: numpy.ndarray, kinematic_viscosity: numpy.ndarray) -> Walther:
        """Through two points, by least squares through more.

        temperature, kinematic_viscosity: shape (points,) [K] and [m2/s]. Raises InputError for lists of different lengths,
        temperatures at which no oil flows, masked values, and viscosities that do not fall. Source: eq-walther."""
        ...
    def kinematic_viscosity(self, temperature: numpy.ndarray) -> object:
        """Any shape [K -> m2/s]. Raises InputError for temperatures at which no oil flows, as degrees Celsius are."""
        ...
    def to_dict(self) -> dict:
        """All members, {name: value}."""
        ...

def composite_modulus(E_1: numpy.ndarray, nu_1: numpy.ndarray, E_2: numpy.ndarray, nu_2: numpy.ndarray) -> object:
    """E' of 2/E' = sum (1 - nu^2)/E [Pa].

    E_1, E_2: Young's moduli above 0 [Pa], inf for a rigid body. nu_1, nu_2: Poisson's ratios above -1 up to 0.5 [-].
    Numbers or arrays of shapes that fit together. Raises InputError. Source: eq-composite-modulus."""
    ...

def gaussian_integral(n: float, lambda_ratio: numpy.ndarray) -> object:
    """F_n of the lambda ratio lambda, any shape, 0 to 30 [-]. Raises InputError. Source: eq-gaussian-integral."""
    ...

def oil(case: Case) -> Oil:
    """The oil of a case at its oil temperature, an Oil; of a pad its pressures count from their own zero. Raises InputError. Source: docs/theory/oil.md."""
    ...
