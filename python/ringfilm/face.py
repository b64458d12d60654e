"""From a trace over a ring face to the shape that a case requires (docs/theory/face.md).

A trace has no gaps: leave points that were not measured out. NaN and masked points are refused.
"""

from ._ringfilm.face import FaceFit, FaceResidual, FitArtifact, fit_face, read_trace

__all__ = ["FaceFit", "FaceResidual", "FitArtifact", "fit_face", "read_trace"]
