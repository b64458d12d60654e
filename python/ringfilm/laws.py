"""The laws that a cycle is made of, on numpy arrays: contact of rough surfaces, density and viscosity of oil.

Arrays have any shape, and results that of their arguments; a number gives a float. Masked values are refused.
"""

from ._ringfilm.laws import GreenwoodTripp, Oil, Walther, composite_modulus, gaussian_integral, oil, summit_contact

__all__ = ["GreenwoodTripp", "Oil", "Walther", "composite_modulus", "gaussian_integral", "oil", "summit_contact"]
