#include "17_planets/orbits.h"

#include <cmath>

namespace lightwalk {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

// At J2000: AU, -, degrees; and degrees per century.
struct Orbit {
    double half_axis_au, eccentricity, inclination, longitude, perihelion, node, motion;
};
constexpr Orbit orbits[body_count] = {
    {},
    {0.38709927, 0.20563593, 7.00497902, 252.25032350, 77.45779628, 48.33076593, 149472.67411175},
    {0.72333566, 0.00677672, 3.39467605, 181.97909950, 131.60246718, 76.67984255, 58517.81538729},
    {1.00000261, 0.01671123, -0.00001531, 100.46457166, 102.93768193, 0.0, 35999.37244981},
    {},
    {1.52371034, 0.09339410, 1.84969142, -4.55343205, -23.94362959, 49.55953891, 19140.30268499},
    {5.20288700, 0.04838624, 1.30439695, 34.39644051, 14.72847983, 100.47390909, 3034.74612775},
    {9.53667594, 0.05386179, 2.48599187, 49.95424423, 92.59887831, 113.66242448, 1222.49362201},
    {19.18916464, 0.04725744, 0.77263783, 313.23810451, 170.95427630, 74.01692503, 428.48202785},
    {30.06992276, 0.00859048, 1.77004347, -55.12002969, 44.96476227, 131.78422574, 218.45945325},
    {39.48211675, 0.24882730, 17.14001206, 238.92903833, 224.06891629, 110.30393684, 145.20780515},
};

// North pole in degrees, angle of the prime meridian at J2000, degrees per day.
struct Rotation {
    double right_ascension, declination, meridian, rate;
};
constexpr Rotation rotations[body_count] = {
    {286.13, 63.87, 84.176, 14.1844},          {281.0103, 61.4155, 329.5988, 6.1385108},
    {272.76, 67.16, 160.20, -1.4813688},       {0.0, 90.0, 190.147, 360.9856235},
    {269.9949, 66.5392, 38.3213, 13.17635815}, {317.681, 52.887, 176.630, 350.89198226},
    {268.057, 64.495, 284.95, 870.5360},       {40.589, 83.537, 38.90, 810.7939024},
    {257.311, -15.175, 203.81, -501.1600928},  {299.36, 43.46, 249.978, 541.1397757},
    {132.993, -6.163, 302.695, 56.3625225},
};

glm::dvec3 from_ecliptic(double x, double y, double z) { return {y, z, x}; }

glm::dvec3 kepler(const Orbit& orbit, double days) {
    const double longitude = orbit.longitude + std::fmod(orbit.motion * (days / 36525.0), 360.0),
                 e = orbit.eccentricity;
    const double mean = std::remainder(longitude - orbit.perihelion, 360.0) * degree;
    double eccentric = mean + e * std::sin(mean);
    for (int i = 0; i < 12; ++i)  // Newton's method on Kepler's equation
        eccentric -= (eccentric - e * std::sin(eccentric) - mean) / (1 - e * std::cos(eccentric));
    const double a = orbit.half_axis_au * astronomical_unit_m;
    const double x = a * (std::cos(eccentric) - e), y = a * std::sqrt(1 - e * e) * std::sin(eccentric);
    const double w = (orbit.perihelion - orbit.node) * degree, node = orbit.node * degree;
    const double i = orbit.inclination * degree;
    const double along = x * std::cos(w) - y * std::sin(w), across = x * std::sin(w) + y * std::cos(w);
    return from_ecliptic(along * std::cos(node) - across * std::sin(node) * std::cos(i),
                         along * std::sin(node) + across * std::cos(node) * std::cos(i), across * std::sin(i));
}

glm::dvec3 moon_from_earth(double days) {
    const auto turned = [&](double start, double rate) { return (start + std::fmod(rate * days, 360.0)) * degree; };
    const double anomaly = turned(134.963, 13.064993), node = turned(93.272, 13.229350);
    const double longitude = turned(218.316, 13.176396) + 6.289 * degree * std::sin(anomaly);
    const double latitude = 5.128 * degree * std::sin(node), away = 1e3 * (385001 - 20905 * std::cos(anomaly));
    return away * from_ecliptic(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                                std::sin(latitude));
}

glm::dmat3 axes_of(const Rotation& rotation, double days) {
    const glm::dvec3 pole = direction_of(rotation.right_ascension, rotation.declination);
    const glm::dvec3 node = direction_of(rotation.right_ascension + 90, 0), east = glm::cross(pole, node);
    const double turn = (rotation.meridian + std::fmod(rotation.rate * days, 360.0)) * degree;
    const glm::dvec3 meridian = std::cos(turn) * node + std::sin(turn) * east;
    return {glm::cross(pole, meridian), pole, meridian};
}

// Neptune's pole circles about its mean once in seven centuries: Archinal et al., 2018. Terms of others are below 0.1 degrees.
Rotation rotation_of(BodyId body, double days) {
    Rotation rotation = rotations[static_cast<size_t>(body)];
    if (body != BodyId::neptune) return rotation;
    const double n = (357.85 + 52.316 * days / 36525) * degree;
    rotation.right_ascension += 0.70 * std::sin(n);
    rotation.declination -= 0.51 * std::cos(n);
    rotation.meridian -= 0.48 * std::sin(n);
    return rotation;
}

}  // namespace

const std::vector<std::string>& body_names() {
    static const std::vector<std::string> names = {"sun",     "mercury", "venus",  "earth",   "moon", "mars",
                                                   "jupiter", "saturn",  "uranus", "neptune", "pluto"};
    return names;
}

glm::dmat4 Placement::matrix() const {
    glm::dmat4 m(axes);
    m[3] = glm::dvec4(position, 1.0);
    return m;
}

glm::dvec3 direction_of(double right_ascension_deg, double declination_deg) {
    const double ra = right_ascension_deg * degree, dec = declination_deg * degree, tilt = 23.4392911 * degree;
    const double x = std::cos(dec) * std::cos(ra), y = std::cos(dec) * std::sin(ra), z = std::sin(dec);
    return from_ecliptic(x, y * std::cos(tilt) + z * std::sin(tilt), z * std::cos(tilt) - y * std::sin(tilt));
}

glm::dmat3 world_to_galaxy() {
    const glm::dvec3 pole = direction_of(192.85948, 27.12825);
    glm::dvec3 center = direction_of(266.40499, -28.93617);
    center = glm::normalize(center - glm::dot(center, pole) * pole);
    return glm::transpose(glm::dmat3(-glm::cross(pole, center), pole, center));
}

Placement place_body(BodyId body, double days) {
    const auto i = static_cast<size_t>(body);
    Placement placement{.position = glm::dvec3(0.0), .axes = axes_of(rotation_of(body, days), days)};
    if (body == BodyId::moon)
        placement.position = kepler(orbits[static_cast<size_t>(BodyId::earth)], days) + moon_from_earth(days);
    else if (body != BodyId::sun)
        placement.position = kepler(orbits[i], days);
    return placement;
}

}  // namespace lightwalk
