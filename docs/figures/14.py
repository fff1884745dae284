"""Diagrams of chapter 14's lessons: python3 docs/figures/draw.py draws them."""

from math import cos, exp, radians, sin, sqrt

from drawing import (BLUE, EYE, FAINT, GREEN, GREY, INK, MIRROR, NORMAL, PALE_GREY, PALE_ORANGE, PURPLE, RED, SMALL, THIN,
                     Drawing, figure, polar)


@figure("14_box", 900, 430,
        "A room from above, with a probe in its middle and a mirror to the left. The reflected ray meets the right wall; from "
        "the probe the same place lies in another direction than the ray's")
def draw_box(drawing: Drawing):
    p = drawing.panel((450, 205), 165)
    p.box((-2, -1.1), (2, 1.1), INK, 4, fill=PALE_GREY)
    place, hit = (-1.2, -0.6), (2.0, 0.75)
    p.line([(-1.5, -0.75), (-0.9, -0.75)], GREY, 5)
    place = (-1.2, -0.75)
    p.arrow(place, hit, RED, "")
    p.arrow((0, 0.1), hit, GREEN, "")
    slope = (hit[1] - place[1]) / (hit[0] - place[0])
    p.arrow((0, 0.1), (1.6, 0.1 + 1.6 * slope), BLUE, "", dash=True)
    p.dot((0, 0.1), INK)
    p.dot(place, INK)
    p.dot(hit, INK)
    p.text((0, 0.1), "center", INK, SMALL, offset=(-40, 18))
    p.text(place, "position", INK, SMALL, offset=(0, -26))
    p.text((0.4, -0.08), "direction", RED, SMALL, offset=(20, -32))
    p.text((1.0, 0.42), "box_project", GREEN, SMALL, offset=(-60, 34))
    p.text((1.6, 0.1 + 1.6 * slope), "without it", BLUE, SMALL, offset=(-30, 34))


ATTACK_S, RELEASE_S, STEP_S = 0.010, 0.150, 1 / 128
BEATS_S = (0.1, 0.5, 0.72, 0.9)


def measured(t: float) -> float:
    """A drum: a strike that fades within some hundredths of a second."""
    return max((0.95 * exp(-(t - beat) / 0.03) for beat in BEATS_S if t >= beat), default=0.0)


@figure("14_levels", 1000, 330,
        "The measured level of a drum, grey, and the smoothed level, blue, which reaches each beat within hundredths of a "
        "second and falls to 37 percent in 150 milliseconds")
def draw_levels(drawing: Drawing):
    p = drawing.panel((60, 60), 740)
    high = 0.26
    p.arrow((0, 0), (1.2, 0), GREY, "*t*", width=2)
    p.arrow((0, 0), (0, 0.32), GREY, width=2)
    p.line([(i / 1000, high * measured(i / 1000)) for i in range(1190)], FAINT, 3)
    level, points = 0.0, []
    for i in range(int(1.19 / STEP_S)):
        now = measured(i * STEP_S)
        level += (now - level) * (1 - exp(-STEP_S / (ATTACK_S if now > level else RELEASE_S)))
        points.append((i * STEP_S, high * level))
    p.line(points, BLUE)
    p.line([(0.2, -0.012), (0.2, 0.012)], GREY, THIN)
    p.text((0.2, -0.04), "0.2 s", GREY, SMALL)
    p.text((0.3, 0.2), "measured", GREY, SMALL)
    p.text((0.3, 0.255), "smoothed", BLUE, SMALL)
    p.text((0.02, 0.34), "level", INK, SMALL, anchor="start")


ALPHA, VIEW = 0.45, 58.0  # the view is so many degrees from the normal


def reflected(angle: float) -> float:
    """BRDF times cosine in the plane of incidence, of light from so many degrees from the normal, away from the view."""
    l, v = radians(angle), radians(-VIEW)
    if abs(angle) >= 90:
        return 0.0
    half = 0.5 * (l + v)
    a, c = ALPHA * ALPHA, cos(half) ** 2
    density = a / (c * (a - 1) + 1) ** 2
    masking = 0.5 / (cos(v) * sqrt(cos(l) ** 2 * (1 - a) + a) + cos(l) * sqrt(cos(v) ** 2 * (1 - a) + a))
    return density * masking * cos(l)


@figure("14_lobe", 900, 420,
        "The lobe of a rough reflection: its peak and its middle lie between the mirror direction and the normal, along the "
        "dominant direction")
def draw_lobe(drawing: Drawing):
    p = drawing.panel((430, 50), 290)
    p.ground(-1.3, 1.3)
    angles = [-89 + i for i in range(179)]
    most = max(reflected(a) for a in angles)
    p.line([(0, 0)] + [polar(0.95 * reflected(a) / most, 90 - a) for a in angles], GREY, 1.6, closed=True, fill=PALE_ORANGE)
    p.arrow((0, 0), (0, 1.15), NORMAL, "*n*")
    p.arrow((0, 0), polar(1.15, 90 + VIEW), EYE, "*v*")
    p.arrow((0, 0), polar(1.15, 90 - VIEW), MIRROR, "*r*")
    share = (1 - ALPHA) * (sqrt(1 - ALPHA) + ALPHA)
    x, y = share * sin(radians(VIEW)), (1 - share) + share * cos(radians(VIEW))
    length = sqrt(x * x + y * y)
    p.arrow((0, 0), (1.15 * x / length, 1.15 * y / length), PURPLE, "*d*")
    p.text((0.9, 0.95), "α = 0.45", GREY, SMALL, offset=(60, 20))


@figure("14_horizons", 900, 400,
        "A slice through a surface that the camera sees from above. On each side of a point the highest direction that meets a "
        "surface is a horizon; light arrives between the two. The angles of the horizons and of the normal are measured from the "
        "line of sight")
def draw_horizons(drawing: Drawing):
    p = drawing.panel((450, 120), 100)
    left, right = (-1.5, 1.35), (1.5, 0.9)
    up, aside = (-2.67, 2.4), (3.33, 2.0)  # ends of the horizons' rays
    ground = [(-3.8, 0.6), (-2.6, 0.8), (-2.2, 1.5), left, (-1.25, 0.46), (0, 0), (1.4, -0.52), right, (2.3, 1.0), (2.6, -0.8), (3.8, -0.9)]
    p.line([(0, 0), up, (aside[0], up[1]), aside], None, fill=PALE_ORANGE)
    p.line([*ground, (3.8, -1.1), (-3.8, -1.1)], None, fill=PALE_GREY)
    p.line(ground, INK, 4)
    p.line([(0, 0), up], RED, THIN, dash=True)
    p.line([(0, 0), aside], RED, THIN, dash=True)
    p.line([(0, 0), (0, 2.1)], EYE, THIN)
    p.eye((0, 2.3), 270)
    p.arrow((0, 0), polar(1.5, 70), NORMAL, "normal", anchor="start", offset=(12, 6))
    for at in ((-0.5, 0.18), (-1.0, 0.37), left, (-2.0, 1.46), (0.5, -0.19), (1.0, -0.37), right, (2.0, 0.96)):
        p.dot(at, RED if at in (left, right) else BLUE, radius_px=6)
    p.dot((0, 0), INK)
    p.arc((0, 0), 0.75, 90, 138, "*h*_{1}", RED)
    p.arc((0, 0), 0.75, 31, 90, "*h*_{2}", RED, offset=(14, -2))
    p.arc((0, 0), 1.15, 70, 90, "*n*", NORMAL)
    p.text((0, 0), "surface", INK, SMALL, offset=(-10, -26))
    p.text((0.1, 1.8), "line of sight", EYE, SMALL, anchor="start")
    p.text((-1.1, 2.1), "light arrives", INK, SMALL)
    p.text((-3.2, 1.3), "hidden", GREY, SMALL)
    p.text((3.1, 0.6), "hidden", GREY, SMALL)
