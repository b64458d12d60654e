# Written by script/python-stubs; do not edit.
"""Laws of contact and oil; see ringfilm.laws."""

from typing import *

import numpy
from . import Case


class GreenwoodTripp:
    """Contact of two rough surfaces after Greenwood and Tripp (1971).

    N [1/m2], beta [m], sigma [m], E_prime [Pa] of 2/E_prime = sum (1 - nu^2)/E. Source: eq-asperity-load."""
    def __init__(self, N: float, beta: float, sigma: float, E_prime: float, integrals: str = 'exact') -> None:
        """integrals: "exact", "polynomial-4-digit", "polynomial-as-printed". Raises InputError."""
        ...
    def area_share(self, h: numpy.ndarray) -> object:
        """Real contact area per nominal area, any shape [m -> -]. Source: eq-asperity-area."""
        ...
    def pressure(self, h: numpy.ndarray) -> object:
        """Pressure on the nominal area at the separation h, any shape [m -> Pa]."""
        ...
    def pressure_slope(self, h: numpy.ndarray) -> object:
        """Its slope over h, any shape [m -> Pa/m]."""
        ...

class Oil:
    """Density and viscosity of an oil at one temperature, against absolute pressure."""
    def density(self, pressure: numpy.ndarray) -> object:
        """Density, any shape [Pa -> kg/m3]."""
        ...
    def viscosity(self, pressure: numpy.ndarray) -> object:
        """Dynamic viscosity, any shape [Pa -> Pa s]."""
        ...

class Walther:
    """Kinematic viscosity against temperature after ASTM D341. Source: eq-walther."""
    @staticmethod
    def fit(temperature: numpy.ndarray, kinematic_viscosity: numpy.ndarray) -> Walther:
        """Through two points or more: shape (points,) [K] and [m2/s]. Raises InputError."""
        ...
    def kinematic_viscosity(self, temperature: numpy.ndarray) -> object:
        """Any shape [K -> m2/s]."""
        ...

def composite_modulus(E_1: numpy.ndarray, nu_1: numpy.ndarray, E_2: numpy.ndarray, nu_2: numpy.ndarray) -> object:
    """E' of 2/E' = sum (1 - nu^2)/E; numbers or arrays [Pa]. Source: eq-composite-modulus."""
    ...

def gaussian_integral(n: float, film_parameter: numpy.ndarray) -> object:
    """F_n of the film parameter lambda, any shape, 0 to 30 [-]. Raises InputError. Source: eq-gaussian-integral."""
    ...

def oil(case: Case) -> Oil:
    """The oil of a case at its oil temperature, an Oil; of a pad its pressures count from their own zero. Raises InputError. Source: docs/theory/oil.md."""
    ...
