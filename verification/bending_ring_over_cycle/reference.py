"""Clearance of a ring with an end gap in a valley of a bore of fourth order, by the beam elements of
thin_ring_closure (README.md). Prints JSON, SI."""

import contextlib
import io
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "thin_ring_closure"))
with contextlib.redirect_stdout(io.StringIO()):
    from reference import Beam

ring = Beam(720, 0.35e-3, [], [(4, -6e-6)])
print(json.dumps({"clearance at the tips": ring.solve()["largest clearance, by beam elements"]}, indent=1))
