"""Temperature of a sheared parallel film above its walls (README.md). Prints JSON, SI."""

import json

ETA, K = 5.06e-3, 0.14

print(json.dumps({f"rise at {speed} m/s": ETA * speed**2 / (12 * K) for speed in (6.5, 23.8)}, indent=1))
