"""Friction loops of a lateral force microscope to the coefficient of boundary shear strength.

NaN and masked values are refused: leave such lines out. Theory in docs/theory/boundary-shear.md, files in
docs/manual/lateral-force.md.
"""

from ._ringfilm.lateral_force import (
    Calibration,
    ForceSample,
    LineFit,
    LoadFriction,
    LoopFriction,
    ShearStrength,
    boundary_shear_strengths,
    calibrate_on_silicon,
    fit_line,
    loop_friction,
    read,
)

__all__ = [
    "Calibration",
    "ForceSample",
    "LineFit",
    "LoadFriction",
    "LoopFriction",
    "ShearStrength",
    "boundary_shear_strengths",
    "calibrate_on_silicon",
    "fit_line",
    "loop_friction",
    "read",
]
