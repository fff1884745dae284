"""Blinn–Phong's normalisation: the exact factor, the common one, and numerical integrals of both.

python3 docs/figures/02_normalisation.py
"""

from math import acos, cos, degrees, pi, radians, sin, sqrt


def exact(n: float) -> float:
    return (n + 2) * (n + 4) / (8 * pi * (2 ** (-n / 2) + n))


def common(n: float) -> float:
    return (n + 8) / (8 * pi)


def lobe(n: float, eye_rad: float = 0.0, rings: int = 400, sectors: int = 400) -> float:
    """The integral of (N·H)^n N·L over the hemisphere of L, by the midpoint rule in cos(theta) and phi."""
    eye_x, eye_z, total = sin(eye_rad), cos(eye_rad), 0.0
    for ring in range(rings):
        z = (ring + 0.5) / rings
        side = sqrt(1 - z * z)
        for sector in range(sectors):
            phi = 2 * pi * (sector + 0.5) / sectors
            hx, hy, hz = side * cos(phi) + eye_x, side * sin(phi), z + eye_z
            total += (hz / sqrt(hx * hx + hy * hy + hz * hz)) ** n * z
    return total * 2 * pi / (rings * sectors)


print("eye at the zenith: share of the light that is reflected, which should be 1; half width of the highlight")
print(f"{'n':>5} {'without':>8} {'exact':>8} {'(n+8)/8pi':>10} {'overshoot':>10} {'pi x exact':>11} {'half width':>11}")
for n in (0, 1, 2, 5, 10, 20, 40, 80, 200):
    whole = lobe(n)
    print(f"{n:5} {whole / pi:8.3f} {whole * exact(n):8.4f} {whole * common(n):10.4f} {common(n) / exact(n) - 1:10.2%}"
          f" {pi * exact(n):11.2f} {degrees(acos(0.5 ** (1 / n))) if n else 90:10.1f}°")
worst = max(range(10000), key=lambda n: common(n / 100) / exact(n / 100)) / 100
print(f"the common factor is worst at n = {worst}: {common(worst) / exact(worst) - 1:.2%}")
print("\neye at an angle from the zenith: share reflected with the exact factor")
angles = (0, 15, 30, 45, 60, 75, 85)
print(f"{'n':>5}" + "".join(f" {angle:6}°" for angle in angles))
for n in (2, 10, 80):
    print(f"{n:5}" + "".join(f" {lobe(n, radians(angle)) * exact(n):7.3f}" for angle in angles))
print("\nan interpolated normal left as it is, half-way between two unit normals: its length, and a highlight's loss")
for between in (5, 10, 20, 40):
    length = cos(radians(between / 2))
    print(f"{between:3}° apart: length {length:.4f}, to the power of 80: {length**80:.3f}")
