"""Falloffs with an end, against the inverse square: the share kept, and a light's reach down to a threshold.

python3 docs/figures/03_windows.py
"""

from math import log, pi, sqrt


def window(share: float) -> float:
    return (1 - share ** 4) ** 2


def fade(share: float) -> float:
    return (1 - share) ** 2


print("what the factor that ends a light leaves of it, at a share of its range")
print(f"{'d/r':>5} {'(1-(d/r)^4)^2':>14} {'(1-d/r)^2':>10}")
for share in (0.1, 0.25, 0.5, 0.75, 0.9, 1.0):
    print(f"{share:5} {window(share):14.3f} {fade(share):10.3f}")
print("\n1 / (d^2 + 1) against 1 / d^2")
for distance in (0.5, 1, 2, 3, 5, 10):
    print(f"{distance:4} m: {distance ** 2 / (distance ** 2 + 1):6.1%} of it")
print("\nwhere an inverse square has fallen to a threshold: sqrt(I / threshold), in metres")
print(f"{'I':>6}" + "".join(f" {name:>8}" for name in ("0.256", "1/16", "0.004", "1/256", "0.0005")))
for intensity in (1, 10, 100):
    print(f"{intensity:6}" + "".join(f" {sqrt(intensity / t):8.1f}" for t in (0.256, 1 / 16, 0.004, 1 / 256, 0.0005)))
print("\na floor with a light of intensity 1 above each square metre, 1 m high: what lights farther away than R add")
for radius in (2, 5, 10, 20, 50, 100):
    # A ring of radius s has 2 pi s ds lights, each 1 / (s^2 + 1) times the cosine 1 / sqrt(s^2 + 1).
    print(f"{radius:4} m: {2 * pi / sqrt(radius ** 2 + 1):.3f} of {2 * pi:.3f} in all")
print("a wall that faces them instead: 2 pi ln(R / 1 m) up to R, without end")
for radius in (10, 100, 1000):
    print(f"{radius:4} m: {2 * pi * log(radius):.1f}")
