"""The mean of normals: where they differ it is shorter than 1, and its length says by how much.

python3 docs/figures/04_mip_normals.py writes docs/images/04_mip_normals.svg.
"""

from math import cos, hypot, radians, sin, tan

from drawing import BLUE, GREY, INK, NORMAL, SMALL, THIN, Drawing, between, polar

CASES = (("smooth", (90, 86, 94, 90)), ("rough", (128, 60, 118, 50)))  # directions of the texels' normals, in degrees


def mean(angles):
    return (sum(cos(radians(a)) for a in angles) / len(angles), sum(sin(radians(a)) for a in angles) / len(angles))


def draw() -> Drawing:
    drawing = Drawing(900, 400, "Four texels with nearly equal normals have a mean of length 1; four texels whose normals scatter have a "
                                "mean that is clearly shorter than the unit circle")
    for i, (name, angles) in enumerate(CASES):
        p = drawing.panel((450 * i, 0), 1)
        p.text((225, 372), name)
        profile = [(60.0, 225.0)]
        for angle in angles:  # a texel's piece of surface leans as its normal says
            x, y = profile[-1]
            profile.append((x + 82.5, y - 82.5 / tan(radians(angle))))
        for (a, b), angle in zip(zip(profile, profile[1:]), angles):
            p.arrow(between(a, b), polar(70, angle, between(a, b)), NORMAL)
        p.line(profile, INK)
        for point in profile:
            p.dot(point, INK, radius_px=4)
        center = (225.0, 55.0)
        p.arrow((225, 198), (225, 176), GREY, width=THIN)
        p.text((240, 189), "mean", GREY, SMALL, anchor="start")
        p.curve(lambda angle, c=center: polar(108, angle, c), 15, 165, GREY, THIN, dash=True)
        p.text(polar(108, 15, center), "length 1", GREY, SMALL, anchor="start", offset=(8, 4))
        x, y = mean(angles)
        tip = (center[0] + 108 * x, center[1] + 108 * y)
        p.arrow(center, tip, BLUE)
        p.text(between(center, tip, 0.3), f"ℓ = {hypot(x, y):.2f}", BLUE, anchor="start", offset=(10, 0))
        p.line([(150, 55), (300, 55)], INK)
    return drawing


if __name__ == "__main__":
    draw().write(__file__)
