"""How wrong a float becomes when its decimal text is read the obvious way.

python3 docs/figures/01_rounding.py
"""

import random
import struct
from fractions import Fraction


def single(x) -> float:
    """A double rounded to the nearest 32-bit float, ties to even."""
    return struct.unpack("<f", struct.pack("<f", float(x)))[0]


def bits(x: float) -> int:
    """A float's place among all floats in order, so that neighbours differ by 1: their distance in ULP."""
    word = struct.unpack("<i", struct.pack("<f", x))[0]
    return word if word >= 0 else -(word & 0x7FFFFFFF)


def nearest(text: str) -> float:
    """The 32-bit float nearest to the decimal, in exact arithmetic; a tie goes to the even one."""
    exact, guess = Fraction(text), single(float(text))
    word = struct.unpack("<I", struct.pack("<f", guess))[0]
    near = [struct.unpack("<f", struct.pack("<I", word + k))[0] for k in (-1, 0, 1) if word + k >= 0]
    return min(near, key=lambda f: (abs(Fraction(f) - exact), bits(f) & 1))


def digit_by_digit(text: str) -> float:
    """All in 32 bits: value * 10 + digit, then digits behind the point times 0.1, 0.01, ..."""
    value, scale, behind = 0.0, 1.0, False
    for c in text.lstrip("-"):
        if c == ".":
            behind = True
        elif behind:
            scale = single(scale * single(0.1))
            value = single(value + single(int(c) * scale))
        else:
            value = single(single(value * 10) + int(c))
    return -value if text.startswith("-") else value


def whole_times_power(text: str) -> float:
    """All digits as an integer in 32 bits, times a power of ten in 32 bits."""
    value = single(int(text.replace(".", "").replace("-", "")))
    for _ in text.partition(".")[2]:
        value = single(value * single(0.1))
    return -value if text.startswith("-") else value


def through_double(text: str) -> float:
    return single(float(text))


random.seed(1)
texts = [f"{random.uniform(-1, 1):.6f}" for _ in range(100000)]
right = [nearest(text) for text in texts]
print(f"{len(texts)} numbers such as {texts[0]}")
print(f"{'method':<20} {'wrong':>8} {'max ULP':>8}")
for method in (digit_by_digit, whole_times_power, through_double):
    errors = [abs(bits(method(text)) - bits(good)) for text, good in zip(texts, right)]
    print(f"{method.__name__:<20} {sum(e > 0 for e in errors) / len(errors):8.2%} {max(errors):8}")

hard = "1.00000005960464477539062500001"
print(f"\n{hard}\n  nearest float  {nearest(hard):.9g}\n  through double {through_double(hard):.9g}")
