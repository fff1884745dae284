"""The step of a 32-bit depth buffer in metres: how far apart two surfaces must be to get two depths.

python3 docs/figures/01_depth.py [NEAR_M FAR_M]
"""

import struct
import sys


def next_float(x: float) -> float:
    """The next 32-bit float after x, away from 0."""
    return struct.unpack("<f", struct.pack("<I", struct.unpack("<I", struct.pack("<f", x))[0] + 1))[0]


def step(depth, distance_m, slope):
    at = struct.unpack("<f", struct.pack("<f", depth(distance_m)))[0]
    return (next_float(at) - at) / slope(distance_m)


near, far = (float(word) for word in sys.argv[1:3]) if len(sys.argv) > 2 else (0.05, 1000.0)
print(f"near {near} m, far {far} m; steps in metres")
print(f"{'distance':>9} {'0 near, 1 far':>14} {'1 near, 0 far':>14}")
for z in (0.1, 1.0, 10.0, 100.0, 900.0):
    slope = near * far / (far - near) / z**2
    forward = step(lambda z: far / (far - near) * (1 - near / z), z, lambda z: slope)
    reverse = step(lambda z: near / (far - near) * (far / z - 1), z, lambda z: slope)
    print(f"{z:7.1f} m {forward:14.2e} {reverse:14.2e}")
