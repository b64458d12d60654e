"""From a trace over a ring face to the shape that a case wants (docs/theory/face.md)."""

from ._ringfilm.face import FaceFit, FaceResidual, InventedShape, fit_face, read_trace

__all__ = ["FaceFit", "FaceResidual", "InventedShape", "fit_face", "read_trace"]
