// The sky of a clear day seen from the ground, as a formula: A. J. Preetham, P. Shirley and B. Smits, "A practical
// analytic model for daylight", SIGGRAPH 1999, pp. 91-100, appendix A.2. Directions have unit length, +y is up.
// `turbidity` measures haze: 2 very clear, 3 clear, 6 warm and moist, 10 haze. The fit was made for 2 to 10, and for
// a sun above the horizon: other values are clamped (below a turbidity of 1.203 the formula is infinite at the
// horizon).
const float preetham_least_turbidity = 1.7, preetham_most_turbidity = 10.0;

// R. Perez et al., Solar Energy 50(3), 1993: relative luminance towards a zenith angle, at an angle from the sun.
float perez(vec3 ab_c, vec2 d_e, float cos_zenith, float angle) {
    float cos_angle = cos(angle);
    return (1.0 + ab_c.x * exp(ab_c.y / cos_zenith)) *
           (1.0 + ab_c.z * exp(d_e.x * angle) + d_e.y * cos_angle * cos_angle);
}

// CIE x, y and Y, this in kcd/m².
vec3 preetham_xyY(vec3 direction, vec3 to_sun, float turbidity) {
    float t = clamp(turbidity, preetham_least_turbidity, preetham_most_turbidity);
    float cos_sun = clamp(to_sun.y, 0.0, 1.0), s = acos(cos_sun);
    float cos_zenith = max(direction.y, 1e-3);
    float angle = atan(length(cross(direction, to_sun)), dot(direction, to_sun));

    vec3 lower = vec3(1.0, t, t * t), powers = vec3(s, s * s, s * s * s);
    vec3 x_of = vec3(0.25886 + dot(powers, vec3(0.06052, -0.21196, 0.11693)),
                     0.00394 + dot(powers, vec3(-0.03202, 0.06377, -0.02903)), dot(powers, vec3(0.00209, -0.00375, 0.00166)));
    vec3 y_of = vec3(0.26688 + dot(powers, vec3(0.06670, -0.26756, 0.15346)),
                     0.00516 + dot(powers, vec3(-0.04153, 0.08970, -0.04214)), dot(powers, vec3(0.00317, -0.00610, 0.00275)));
    float luminance = (4.0453 * t - 4.9710) * tan((4.0 / 9.0 - t / 120.0) * (3.14159265 - 2.0 * s)) - 0.2155 * t + 2.4192;
    vec3 zenith = vec3(dot(lower, x_of), dot(lower, y_of), max(luminance, 0.0));

    vec3 x_abc = vec3(-0.0193, -0.0665, -0.0004) * t + vec3(-0.2592, 0.0008, 0.2125);
    vec3 y_abc = vec3(-0.0167, -0.0950, -0.0079) * t + vec3(-0.2608, 0.0092, 0.2102);
    vec3 l_abc = vec3(0.1787, -0.3554, -0.0227) * t + vec3(-1.4630, 0.4275, 5.3251);
    vec2 x_de = vec2(-0.0641, -0.0033) * t + vec2(-0.8989, 0.0452);
    vec2 y_de = vec2(-0.0441, -0.0109) * t + vec2(-1.6537, 0.0529);
    vec2 l_de = vec2(0.1206, -0.0670) * t + vec2(-2.5771, 0.3703);
    vec3 there = vec3(perez(x_abc, x_de, cos_zenith, angle), perez(y_abc, y_de, cos_zenith, angle),
                      perez(l_abc, l_de, cos_zenith, angle));
    vec3 above = vec3(perez(x_abc, x_de, 1.0, s), perez(y_abc, y_de, 1.0, s), perez(l_abc, l_de, 1.0, s));
    return zenith * there / above;
}

// From CIE XYZ to light with Rec. 709 primaries.
vec3 xyz_to_rgb(vec3 c) {
    return vec3(dot(c, vec3(3.2406, -1.5372, -0.4986)), dot(c, vec3(-0.9689, 1.8758, 0.0415)),
                dot(c, vec3(0.0557, -0.2040, 1.0570)));
}

// Linear light, kcd/m², no channel below 0. Below the horizon the zenith angle is the horizon's.
vec3 preetham_sky(vec3 direction, vec3 to_sun, float turbidity) {
    vec3 c = preetham_xyY(direction, to_sun, turbidity);
    return max(xyz_to_rgb(vec3(c.x, c.y, 1.0 - c.x - c.y) * (c.z / max(c.y, 1e-3))), 0.0);
}

// Sunlight that reaches the ground, in red, green and blue: Rayleigh scattering and haze after the same paper's
// appendix A.1, at 650, 570 and 475 nm; F. Kasten and A. T. Young's air mass, Applied Optics 28(22), 1989. 0 to 1;
// below the horizon it is the horizon's.
vec3 preetham_sunlight(vec3 to_sun, float turbidity) {
    float elevation_deg = max(degrees(asin(clamp(to_sun.y, -1.0, 1.0))), 0.0);
    float air_mass = 1.0 / (max(to_sun.y, 0.0) + 0.50572 * pow(elevation_deg + 6.07995, -1.6364));
    float haze = 0.04608 * clamp(turbidity, preetham_least_turbidity, preetham_most_turbidity) - 0.04586;
    const vec3 wavelength_um = vec3(0.650, 0.570, 0.475);
    return exp(-air_mass * (0.008735 * pow(wavelength_um, vec3(-4.08)) + haze * pow(wavelength_um, vec3(-1.3))));
}
