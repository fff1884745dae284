// The reference: ACES 1.0's rendering transform (RRT) and its output transform (ODT) for Rec. 709 at 100 nits in dim
// surround, from linear Rec. 709 to linear Rec. 709 from 0 to 1. Academy of Motion Picture Arts and Sciences, ACES system,
// 2014; constants as published there. Matrices from the primaries of AP0 (SMPTE ST 2065-1), AP1 (S-2014-004) and Rec. 709,
// Bradford between D65 and D60; truth.h computes them. Columns.
const mat3 rec709_to_ap0 = mat3(0.439632982, 0.089776443, 0.0175411704, 0.382988698, 0.813439429, 0.111546553, 0.17737832,
                                0.0967841283, 0.870912276);
const mat3 ap0_to_ap1 = mat3(1.45143932, -0.0765537734, 0.00831614843, -0.236510747, 1.1762297, -0.00603244979,
                             -0.214928569, -0.0996759264, 0.997716301);
const mat3 ap1_to_rec709 = mat3(1.70505099, -0.130256418, -0.0240033568, -0.621792121, 1.14080474, -0.128968976,
                                -0.083258872, -0.0105483191, 1.15297233);
const vec3 ap1_luminance = vec3(0.27222872, 0.67408177, 0.05368952);

float log10(float x) { return log2(x) * 0.301029996; }

// A uniform quadratic B-spline with these three coefficients on a span, at 0 to 1. The spans of a curve are chosen and not
// looked up: an array that is indexed lies in memory.
float on_span(vec3 c, float t) { return (0.5 * c.x - c.y + 0.5 * c.z) * t * t + (c.y - c.x) * t + 0.5 * (c.x + c.y); }

float rrt_low(float share) {
    float at = 3.0 * share;
    int j = clamp(int(at), 0, 2);
    vec3 c = j == 0 ? vec3(-4.0, -4.0, -3.1573765773)
             : j == 1 ? vec3(-4.0, -3.1573765773, -0.4852499958)
             : vec3(-3.1573765773, -0.4852499958, 1.8477324706);
    return on_span(c, at - float(j));
}
float rrt_high(float share) {
    float at = 3.0 * share;
    int j = clamp(int(at), 0, 2);
    vec3 c = j == 0 ? vec3(-0.7185482425, 2.0810307172, 3.6681241237)
             : j == 1 ? vec3(2.0810307172, 3.6681241237, 4.0)
             : vec3(3.6681241237, 4.0, 4.0);
    return on_span(c, at - float(j));
}
float odt_low(float share) {
    float at = 7.0 * share;
    int j = clamp(int(at), 0, 6);
    vec3 c = j == 0 ? vec3(-1.6989700043, -1.6989700043, -1.4779)
             : j == 1 ? vec3(-1.6989700043, -1.4779, -1.2291)
             : j == 2 ? vec3(-1.4779, -1.2291, -0.8648)
             : j == 3 ? vec3(-1.2291, -0.8648, -0.4480)
             : j == 4 ? vec3(-0.8648, -0.4480, 0.00518)
             : j == 5 ? vec3(-0.4480, 0.00518, 0.4511080334)
             : vec3(0.00518, 0.4511080334, 0.9113744414);
    return on_span(c, at - float(j));
}
float odt_high(float share) {
    float at = 7.0 * share;
    int j = clamp(int(at), 0, 6);
    vec3 c = j == 0 ? vec3(0.5154386965, 0.8470437783, 1.1358)
             : j == 1 ? vec3(0.8470437783, 1.1358, 1.3802)
             : j == 2 ? vec3(1.1358, 1.3802, 1.5197)
             : j == 3 ? vec3(1.3802, 1.5197, 1.5985)
             : j == 4 ? vec3(1.5197, 1.5985, 1.6467)
             : j == 5 ? vec3(1.5985, 1.6467, 1.6746091357)
             : vec3(1.6467, 1.6746091357, 1.6878733390);
    return on_span(c, at - float(j));
}

// Logarithms of light to logarithms of light. The film: from 15 stops below middle grey to 18 above.
float rrt_curve(float l) {
    const float least = -5.26017744, middle = -0.744727495, most = 4.67381243;
    if (l <= least) return -4.0;
    if (l >= most) return 4.0;
    return l < middle ? rrt_low((l - least) / (middle - least)) : rrt_high((l - middle) / (most - middle));
}
// Output transform of the film's 6.5 stops below and above to 0.02 and 48 nits.
float odt_curve(float l) {
    float least = rrt_curve(-0.744727495 - 6.5 * 0.301029996), middle = 0.681241237;
    float most = rrt_curve(-0.744727495 + 6.5 * 0.301029996);
    if (l <= least) return -1.69897;
    if (l >= most) return 0.04 * (l - most) + 1.6812412374;
    return l < middle ? odt_low((l - least) / (middle - least)) : odt_high((l - middle) / (most - middle));
}

// A uniform cubic B-spline around hue 0, 135 degrees wide.
float redness(float hue_deg) {
    float u = abs(hue_deg) * (4.0 / 135.0);
    float inner = (4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0, outer = (2.0 - u) * (2.0 - u) * (2.0 - u) / 6.0;
    return u < 1.0 ? 1.5 * inner : u < 2.0 ? 1.5 * outer : 0.0;
}

vec3 saturated(vec3 ap1, float by) { return mix(vec3(dot(ap1, ap1_luminance)), ap1, by); }

vec3 reference_tone(vec3 radiance) {
    vec3 c = rec709_to_ap0 * max(radiance, 0.0);
    float most = max(c.r, max(c.g, c.b)), least = min(c.r, min(c.g, c.b));
    float saturation = (max(most, 1e-10) - max(least, 1e-10)) / max(most, 1e-2);

    // Dark saturated colours glow.
    float chroma = sqrt(max(c.b * (c.b - c.g) + c.g * (c.g - c.r) + c.r * (c.r - c.b), 0.0));
    float yc = (c.b + c.g + c.r + 1.75 * chroma) / 3.0;
    float x = (saturation - 0.4) / 0.2, t = max(1.0 - abs(0.5 * x), 0.0);
    float gain = 0.05 * 0.5 * (1.0 + sign(x) * (1.0 - t * t));
    c *= 1.0 + (yc <= 2.0 / 3.0 * 0.08 ? gain : yc >= 2.0 * 0.08 ? 0.0 : gain * (0.08 / yc - 0.5));

    // Reds become darker.
    float across = sqrt(3.0) * (c.g - c.b), along = 2.0 * c.r - c.g - c.b;
    float hue_deg = across == 0.0 && along == 0.0 ? 0.0 : degrees(atan(across, along));
    c.r += redness(hue_deg) * saturation * (0.03 - c.r) * (1.0 - 0.82);

    // The film's curve and the screen's, in AP1.
    vec3 film = clamp(saturated(clamp(ap0_to_ap1 * max(c, 0.0), 0.0, 65504.0), 0.96), 1e-10, 65504.0);
    vec3 screen;
    for (int i = 0; i < 3; ++i) screen[i] = pow(10.0, odt_curve(rrt_curve(log10(film[i]))));
    screen = (screen - 0.02) / (48.0 - 0.02);

    // In dim surround the picture looks flatter than it is; and less saturated for a screen.
    float y = dot(screen, ap1_luminance);
    if (y > 0.0) screen *= pow(y, 0.9811 - 1.0);
    return clamp(ap1_to_rec709 * saturated(screen, 0.93), 0.0, 1.0);
}
