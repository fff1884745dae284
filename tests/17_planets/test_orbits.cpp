// Orbits against positions of the library ERFA 2.0 (planets: J. Simon et al., 1994; the Moon: J. Meeus, 1998), and Kepler's laws.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "../catch.h"
#include "17_planets/maps.h"

using namespace lightwalk;

namespace {

struct Ecliptic {
    double longitude_deg, latitude_deg, away;
};

// +z is the vernal equinox, +x 90 degrees along the ecliptic from it.
Ecliptic ecliptic(glm::dvec3 v) {
    return {glm::degrees(std::atan2(v.x, v.z)), glm::degrees(std::asin(v.y / glm::length(v))), glm::length(v)};
}

struct Known {
    BodyId body;
    double days, longitude_deg, latitude_deg, away_au;
};
const Known planets_of_erfa[] = {
    {BodyId::mercury, -4321.5, 222.614, 0.703, 0.4460},  {BodyId::mercury, 1234.25, 261.145, -3.810, 0.4664},
    {BodyId::mercury, 9000.75, 342.911, -6.373, 0.3771}, {BodyId::venus, -4321.5, 97.914, 1.229, 0.7193},
    {BodyId::venus, 1234.25, 358.859, -3.318, 0.7266},   {BodyId::venus, 9000.75, 203.135, 2.729, 0.7217},
    {BodyId::earth, -4321.5, 162.799, 0.000, 0.9914},    {BodyId::earth, 1234.25, 238.310, 0.000, 1.0118},
    {BodyId::earth, 9000.75, 330.267, 0.001, 1.0112},    {BodyId::mars, -4321.5, 240.131, -0.339, 1.5249},
    {BodyId::mars, 1234.25, 272.966, -1.271, 1.4490},    {BodyId::mars, 9000.75, 41.577, -0.254, 1.4539},
    {BodyId::jupiter, -4321.5, 37.298, -1.163, 4.9683},  {BodyId::jupiter, 1234.25, 141.470, 0.855, 5.3454},
    {BodyId::jupiter, 9000.75, 66.548, -0.728, 5.0420},  {BodyId::saturn, -4321.5, 266.120, 1.153, 10.0418},
    {BodyId::saturn, 1234.25, 91.290, -0.948, 9.0320},   {BodyId::saturn, 9000.75, 345.153, -1.950, 9.6697},
    {BodyId::uranus, -4321.5, 267.959, -0.187, 19.2583}, {BodyId::uranus, 1234.25, 329.747, -0.749, 20.0241},
    {BodyId::uranus, 9000.75, 53.919, -0.266, 19.5739},  {BodyId::neptune, -4321.5, 278.260, 0.978, 30.2276},
    {BodyId::neptune, 1234.25, 311.280, 0.016, 30.0810}, {BodyId::neptune, 9000.75, 357.992, -1.278, 29.8983}};

// Every 137.31 days from 4,000 days before J2000; distances in 1,000 km.
const Ecliptic moon_of_erfa[] = {
    {78.07, 5.06, 383.5},   {87.31, 4.42, 372.8},   {99.17, 3.57, 376.8},   {105.60, 2.68, 379.1},
    {113.73, 1.25, 367.9},  {125.61, -0.59, 368.1}, {132.57, -1.70, 374.6}, {139.48, -2.69, 365.1},
    {150.82, -4.09, 360.7}, {159.29, -4.91, 370.3}, {165.25, -5.05, 365.0}, {175.65, -4.94, 356.8},
    {185.88, -4.65, 367.0}, {191.20, -4.16, 367.6}, {200.46, -2.91, 357.7}, {211.98, -1.29, 365.3},
    {217.32, -0.31, 371.4}, {225.50, 0.95, 361.9},  {237.60, 2.73, 365.2},  {243.95, 3.81, 375.1},
    {251.47, 4.43, 368.3},  {263.36, 4.92, 367.5},  {271.24, 5.17, 379.0},  {278.35, 5.03, 376.6},
    {289.47, 4.07, 373.0},  {298.88, 2.91, 383.3},  {305.77, 2.00, 385.3},  {316.06, 0.53, 380.6},
    {326.69, -1.26, 387.8}, {333.87, -2.55, 393.0}, {343.75, -3.61, 388.4}, {355.00, -4.48, 392.4},
    {2.78, -5.12, 399.1},   {12.51, -5.25, 395.4},  {23.82, -4.60, 396.9},  {32.16, -3.81, 403.0},
    {41.70, -2.92, 400.6},  {52.65, -1.46, 400.8},  {61.56, 0.20, 405.2},   {71.07, 1.67, 403.8},
    {81.75, 2.91, 403.8},   {91.13, 3.97, 406.5},   {100.62, 4.91, 405.0},  {111.33, 5.23, 404.8},
    {121.00, 4.86, 406.4},  {130.19, 4.34, 403.5},  {140.96, 3.51, 403.1},  {150.67, 2.21, 404.9},
    {159.33, 0.63, 400.2},  {170.29, -0.94, 399.3}, {179.99, -2.16, 402.3}, {188.04, -3.39, 396.4},
    {199.24, -4.61, 393.8}, {209.20, -5.08, 397.9}, {216.78, -5.01, 392.0}, {227.79, -4.78, 386.5},
    {238.04, -4.18, 391.0}, {245.22, -3.15, 387.3}, {255.36, -1.60, 378.7}, {266.01, -0.11, 382.7}};

}  // namespace

TEST_CASE("planets stand where ERFA has them: between 1988 and 2024 within a fifth of a degree", "[17.orbits]") {
    for (const Known& known : planets_of_erfa) {
        const Ecliptic found = ecliptic(place_body(known.body, known.days).position);
        const double along = std::remainder(found.longitude_deg - known.longitude_deg, 360.0);
        fmt::print("{} {}: {:.3f} and {:.3f} degrees, {:.5f} of its distance\n", body_names()[size_t(known.body)],
                   known.days, along, found.latitude_deg - known.latitude_deg,
                   found.away / astronomical_unit_m / known.away_au - 1);
        CHECK(std::fabs(along) < 0.2);
        CHECK(found.latitude_deg == Approx(known.latitude_deg).margin(0.02));
        CHECK(found.away / astronomical_unit_m == Approx(known.away_au).epsilon(0.002));
    }
}

// Worst dates of each in steps of 3.65 days: from 2000 to 2050, and from 1900 to 2100.
TEST_CASE("accuracies that the lesson states hold from 2000 to 2050, and outside those of the longer time",
          "[17.accuracy]") {
    const struct {
        BodyId body;
        double days, longitude_deg, latitude_deg;  // ERFA's
    } worst[] = {{BodyId::mercury, 16936.00, 81.316, 3.831},  {BodyId::venus, 17895.95, 52.911, -1.362},
                 {BodyId::earth, 17187.85, 121.560, -0.005},  {BodyId::mars, 15067.20, 330.064, -1.815},
                 {BodyId::jupiter, 17366.70, 39.448, -1.140}, {BodyId::saturn, 2102.40, 123.529, 0.427},
                 {BodyId::uranus, 12764.05, 97.821, 0.312},   {BodyId::neptune, 13975.85, 28.201, -1.721},
                 {BodyId::moon, 16906.80, 144.002, -1.247},   {BodyId::mercury, -35583.30, 71.001, 2.700},
                 {BodyId::mars, 36350.90, 321.984, -1.840},   {BodyId::saturn, 23703.65, 126.968, 0.580},
                 {BodyId::uranus, 30426.95, 313.624, -0.665}, {BodyId::moon, 35836.25, 84.433, 4.362}};
    double planets[2] = {}, moon[2] = {};  // within the stated years, and outside
    for (const auto& known : worst) {
        glm::dvec3 found = place_body(known.body, known.days).position;
        if (known.body == BodyId::moon) found -= place_body(BodyId::earth, known.days).position;
        const double l = glm::radians(known.longitude_deg), b = glm::radians(known.latitude_deg);
        const glm::dvec3 right(std::cos(b) * std::sin(l), std::sin(b), std::cos(b) * std::cos(l));
        const bool outside = known.days < 0 || known.days > accurate_until_days;
        double& most = (known.body == BodyId::moon ? moon : planets)[outside];
        most = std::max(most, glm::degrees(glm::length(glm::normalize(found) - right)));
    }
    fmt::print("planets {:.3f} and {:.3f} degrees, the Moon {:.2f} and {:.2f}\n", planets[0], planets[1], moon[0],
               moon[1]);
    CHECK(planets[0] == Approx(0.165).margin(0.001));
    CHECK(planets[1] == Approx(0.320).margin(0.001));
    CHECK(moon[0] == Approx(3.11).margin(0.01));
    CHECK(moon[1] == Approx(3.87).margin(0.01));
}

TEST_CASE("a planet's radius sweeps equal areas in equal times, and its energy stays", "[17.orbits]") {
    for (const BodyId body : {BodyId::mercury, BodyId::mars, BodyId::pluto}) {
        const double year = body == BodyId::mercury ? 87.969
                            : body == BodyId::mars  ? 686.98
                                                    : 90560,
                     step = year * 1e-5;
        double least_area = 1e99, most_area = 0, least_axis = 1e99, most_axis = 0;
        for (int i = 0; i < 64; ++i) {
            const double days = year * i / 64;
            const glm::dvec3 at = place_body(body, days).position;
            const glm::dvec3 speed =
                (place_body(body, days + step).position - place_body(body, days - step).position) / (2 * step);
            const double area = glm::length(glm::cross(at, speed));
            least_area = std::min(least_area, area);
            most_area = std::max(most_area, area);
            // Of the energy follows half the orbit's length; the Sun's pull in metres and days.
            const double pull = 1.32712440018e20 * 86400.0 * 86400.0;
            const double axis = 1 / (2 / glm::length(at) - glm::dot(speed, speed) / pull);
            least_axis = std::min(least_axis, axis);
            most_axis = std::max(most_axis, axis);
        }
        INFO(body_names()[size_t(body)]);
        fmt::print("{}: areas differ by {:.1e}, half axes by {:.1e}\n", body_names()[size_t(body)],
                   most_area / least_area - 1, most_axis / least_axis - 1);
        CHECK(most_area / least_area - 1 < 1e-6);
        CHECK(most_axis / least_axis - 1 < 3e-3);
    }
}

TEST_CASE("the Moon's largest terms are those of ERFA's series: longitude, latitude and distance", "[17.orbits]") {
    double of[3] = {0, 0, 0}, squares[3] = {0, 0, 0}, off[3] = {0, 0, 0}, worst[3] = {0, 0, 0};
    int count = 0;
    for (const Ecliptic& known : moon_of_erfa) {
        const double days = -4000 + 137.31 * count++;
        const Ecliptic found =
            ecliptic(place_body(BodyId::moon, days).position - place_body(BodyId::earth, days).position);
        const double mean_deg = 218.316 + 13.176396 * days;  // Meeus, chapter 47
        const double ours[3] = {std::remainder(found.longitude_deg - mean_deg, 360.0), found.latitude_deg,
                                found.away / 1e6 - 385.001};
        const double theirs[3] = {std::remainder(known.longitude_deg - mean_deg, 360.0), known.latitude_deg,
                                  known.away - 385.001};
        for (int k = 0; k < 3; ++k) {
            of[k] += ours[k] * theirs[k];
            squares[k] += ours[k] * ours[k];
            off[k] += (ours[k] - theirs[k]) * (ours[k] - theirs[k]);
            worst[k] = std::max(worst[k], std::fabs(ours[k] - theirs[k]));
        }
    }
    for (int k = 0; k < 3; ++k)
        fmt::print("{}: {:.3f} of the term, off by {:.3f}, at worst {:.3f}\n", k, of[k] / squares[k],
                   std::sqrt(off[k] / count), worst[k]);
    for (int k = 0; k < 3; ++k) CHECK(of[k] / squares[k] == Approx(1).margin(0.05));
    CHECK(std::sqrt(off[0] / count) < 1.3);  // degrees; terms that are left out: 1.27, 0.66 and 0.21 degrees, ...
    CHECK(std::sqrt(off[1] / count) < 0.35);
    CHECK(std::sqrt(off[2] / count) < 3.6);  // 1,000 km: 3.70 and 2.96, ...
}
