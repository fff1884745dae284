#include <cmath>
#include <glm/gtc/constants.hpp>
#include <stdexcept>

#include "17_planets/maps.h"

namespace lightwalk {

namespace {

const glm::vec3 white(1.0f);

SurfaceLaw law(int which, glm::vec3 tint = white) {
    return {.law = which,
            .wrap = 0.2f,
            .wrap_power = 1.4f,
            .minnaert = 0.7f,
            .terminator = white,
            .tint = tint,
            .relief = 1,
            .gloss = 0,
            .ice = 0};
}

// Frost that glosses as the map says, or caps that stay white between dust of another tint.
SurfaceLaw with_ice(float gloss, glm::vec3 tint = white) {
    SurfaceLaw surface = law(LAW_MINNAERT, tint);
    surface.gloss = gloss;
    surface.ice = gloss > 0 ? 0.0f : 1.0f;
    return surface;
}

SurfaceLaw clouds(float k, glm::vec3 terminator, glm::vec3 tint = white) {
    SurfaceLaw surface = law(LAW_MINNAERT, tint);
    surface.minnaert = k;
    surface.terminator = terminator;
    surface.relief = 0;
    return surface;
}

SurfaceLaw wrapped(float w, float k, glm::vec3 terminator, glm::vec3 tint = white) {
    SurfaceLaw surface = law(LAW_WRAPPED, tint);
    surface.wrap = w;
    surface.wrap_power = k;
    surface.terminator = terminator;
    surface.relief = 0;
    return surface;
}

// Radii: NASA's Saturnian rings fact sheet. Optical depths: of C, 0.05 to 0.12, from the same; of A, 0.45 to 0.57,
// from K. Lumme and H. Reitsema, Icarus 33, 1978, page 288; of B, 1 to 3: 1.25 and 1.5 by photometry from the Earth,
// and opaque parts of its middle, by occultations. Single-scattering albedos: 0.9 at most, of C 0.3 at its inner
// edge. The lesson cites the sources, and the parts of them that were read.
constexpr RingPart saturn_rings[] = {{74658e3, 92000e3, 0.09, 0.30},  {92000e3, 99000e3, 1.2, 0.74},
                                     {99000e3, 110000e3, 2.2, 0.88},  {110000e3, 117580e3, 1.6, 0.84},
                                     {117580e3, 122170e3, 0.1, 0.35}, {122170e3, 133423e3, 0.55, 0.66},
                                     {133423e3, 133745e3, 0.0, 0.5},  {133745e3, 136775e3, 0.5, 0.6}};
// Radius, width and optical depth of the ten: PDS Ring-Moon Systems Node, "Vital Statistics for Uranus's Rings and
// Inner Satellites" (after R. French et al. in Uranus, 1991), the middle of a stated range, and for the widest ring
// the depth that fits its mean width; the sheet beside one of them is from memory. The widths vary around the planet.
// Albedo: particles as dark as coal, with a geometric albedo of 0.061 (E. Karkoschka, Icarus 125, 1997, page 348),
// times 4 over their phase function at 0.
constexpr RingPart narrow(double radius_km, double width_km, double depth) {
    return {1e3 * (radius_km - 0.5 * width_km), 1e3 * (radius_km + 0.5 * width_km), depth, 0.052};
}
constexpr RingPart uranus_rings[] = {narrow(41837, 1.5, 0.3), narrow(42234, 2, 0.5),   narrow(42571, 2, 0.3),
                                     narrow(44718, 7, 0.4),   narrow(45661, 8, 0.3),   narrow(47176, 1.6, 0.4),
                                     narrow(47204, 55, 0.02), narrow(47627, 2.5, 0.8), narrow(48300, 5, 0.5),
                                     narrow(50024, 2, 0.1),   narrow(51149, 58, 1.2)};

glm::vec3 per_m(glm::vec3 per_megametre) { return 1e-6f * per_megametre; }

}  // namespace

const BodyTraits& traits(BodyId body) {
    static const BodyTraits all[body_count] = {
        {nullptr, sun_radius_m, 0, BodyKind::star, law(LAW_LAMBERT), 0, 0},
        {"planets_2k/mercury.jpg", 2440.53e3, 0, BodyKind::rock, law(LAW_HAPKE, {0.60f, 0.56f, 0.53f}), 5, 0.22f},
        {"planets_2k/venus.jpg", 6051.8e3, 0, BodyKind::clouded,
         wrapped(0.14f, 1.3f, {1.0f, 0.86f, 0.66f}, {1.0f, 0.98f, 0.94f}), 0, 0},
        {"planets/earth_day.jpg", 6378.137e3, 0.0033528, BodyKind::earth, law(LAW_LAMBERT, {1.08f, 1.04f, 1.0f}), 4,
         0.1f},
        {"planets_2k/moon.jpg", 1737.4e3, 0.0012, BodyKind::rock, law(LAW_HAPKE, {0.60f, 0.58f, 0.56f}), 5, 0.2f},
        {"planets_2k/mars.jpg", 3396.19e3, 0.00589, BodyKind::clouded, with_ice(0, {1.02f, 1.45f, 1.75f}), 5, 0.14f},
        {"planets_2k/jupiter.jpg", 71492e3, 0.06487, BodyKind::flowing, clouds(0.94f, {1.0f, 0.82f, 0.66f}), 0, 0},
        {"planets_2k/saturn.jpg", 60268e3, 0.09796, BodyKind::ringed, clouds(0.90f, {1.0f, 0.88f, 0.72f}), 0, 0},
        {"planets_2k/uranus.jpg", 25559e3, 0.02293, BodyKind::ringed, clouds(0.88f, {0.86f, 0.98f, 1.0f}), 0, 0},
        {"planets_2k/neptune.jpg", 24764e3, 0.01708, BodyKind::rock,
         wrapped(0.06f, 1.25f, {0.72f, 0.84f, 1.0f}, {2.2f, 1.5f, 1.05f}), 0, 0},
        {nullptr, 1188.3e3, 0, BodyKind::clouded, with_ice(1), 5, 0.09f},
    };
    return all[static_cast<size_t>(body)];
}

Air air_of(BodyId body, glm::vec3 sunlight, float sun_rad) {
    Air air{.rayleigh = glm::vec3(0.0f),
            .rayleigh_height = 0,
            .mie = glm::vec3(0.0f),
            .mie_height = 0,
            .mie_extinction = glm::vec3(0.0f),
            .mie_g = 0.5f,
            .layer = glm::vec3(0.0f),
            .layer_center = 0,
            .layer_width = 0,
            .radius = static_cast<float>(traits(body).radius_m),
            .top = 1,
            .sun = glm::pi<float>() * sunlight,
            .sun_rad = sun_rad,
            .ground = glm::vec3(0.2f)};
    const auto set = [&](glm::vec3 molecules, float molecules_m, glm::vec3 dust, glm::vec3 taken, float dust_m,
                         float top_m) {
        air.rayleigh = per_m(molecules);
        air.rayleigh_height = molecules_m;
        air.mie = per_m(dust);
        air.mie_extinction = per_m(taken);
        air.mie_height = dust_m;
        air.top = top_m;
    };
    switch (body) {
        case BodyId::earth:  // chapter 10's
            set({5.802f, 13.558f, 33.1f}, 8000, glm::vec3(3.996f), glm::vec3(4.44f), 1200, 1e5f);
            air.mie_g = 0.76f;
            air.layer = per_m({0.65f, 1.881f, 0.085f});
            air.layer_center = 25000;
            air.layer_width = 15000;
            break;
        case BodyId::mars:  // dust of optical depth 0.25 that takes blue away; molecules are too few to show
            set(glm::vec3(0.0f), 0, {20.0f, 15.5f, 10.0f}, {21.0f, 18.5f, 16.0f}, 11000, 6e4f);
            air.mie_g = 0.6f;
            break;
        case BodyId::venus:  // the thin haze above the clouds; its small drops scatter blue
            set({1.6f, 2.6f, 4.2f}, 5000, glm::vec3(1.2f), glm::vec3(1.25f), 5000, 5e4f);
            break;
        case BodyId::pluto:  // haze up to 200 km, bluish
            set({0.04f, 0.075f, 0.14f}, 45000, glm::vec3(0.06f), glm::vec3(0.062f), 45000, 2.2e5f);
            break;
        default:
            break;
    }
    return air;
}

std::span<const RingPart> ring_parts(BodyId body) {
    if (body == BodyId::saturn) return saturn_rings;
    if (body == BodyId::uranus) return uranus_rings;
    return {};
}

Rings rings_of(BodyId body) {
    if (body == BodyId::saturn) return {.inner = 74000e3f, .outer = 137500e3f, .brightness = 1};
    if (body == BodyId::uranus) return {.inner = 41000e3f, .outer = 51500e3f, .brightness = 1};
    return {.inner = 0, .outer = 0, .brightness = 0};
}

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
