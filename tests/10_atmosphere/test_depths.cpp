// Optical depth by formulas against double precision: wherever the sun stands and however high the place is.
#include <fmt/core.h>

#include "../common/gpu_fixture.h"
#include "10_atmosphere/truth.h"
#include "common/check/probe.h"
#include "known_air.h"

using namespace lightwalk;

namespace {

/// Of the layer, in metres as dense as its middle, by 40,000 places up to the air's edge.
double layer_depth(const Air& air, double height, double slope) {
    const double r = double(air.radius) + height, top = double(air.radius) + double(air.top);
    const double way = -r * slope + std::sqrt(r * r * slope * slope + top * top - r * r);
    constexpr int places = 40000;
    double sum = 0;
    for (int i = 0; i < places; ++i) {
        const double t = (i + 0.5) * way / places, k = 2 * r * slope * t + t * t;
        const double at = height + k / (r + std::sqrt(r * r + k));
        sum += truth::density(at, 1, 1, double(air.layer_center), double(air.layer_width)).z;
    }
    return sum * way / places;
}

double horizon(double height, double radius) { return -std::sqrt(height * (2 * radius + height)) / (radius + height); }

}  // namespace

TEST_CASE("sunlight by a formula: within 0.5% of the depth, from the ground to 60 km, down to the horizon",
          "[figures][10.sunlight]") {
    Air low = earth_air(), high = earth_air();
    low.layer_center = 8000;  // into the ground
    low.layer_width = 12000;
    high.layer_center = 90000;  // and out of the air
    high.layer_width = 20000;
    for (const Air& air : {earth_air(), low, high}) {
        Table inputs;
        for (const double height :
             {0.0, 500.0, 5000.0, 12000.0, 20000.0, 25000.0, 32000.0, 38000.0, 45000.0, 60000.0}) {
            const double least = horizon(height, earth);
            for (const double share : {0.001, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0})
                inputs.push_back({height, double(float(least + share * (1 - least)))});
            inputs.push_back({height, 0});
            if (least < -0.01) inputs.push_back({height, 0.5 * least});
        }
        Probe probe{.include = "10_atmosphere/closed_depth.glsl",
                    .before = with_known_air,
                    .signature = "vec3 closed_depth(float height, float slope)",
                    .inputs = inputs,
                    .macros = known_air(air)};
        const Table found = run_probe(validated_device(), probe, 3);
        double worst = 0;
        for (size_t i = 0; i < inputs.size(); ++i) {
            const double height = inputs[i][0], slope = inputs[i][1];
            const glm::dvec3 right =
                glm::dvec3(air.rayleigh) * truth::optical_depth(height, slope, earth, double(air.rayleigh_height)) +
                glm::dvec3(air.mie_extinction) * truth::optical_depth(height, slope, earth, double(air.mie_height)) +
                glm::dvec3(air.layer) * layer_depth(air, height, slope);
            for (int c = 0; c < 3; ++c) {
                const double off = found[i][size_t(c)] / right[c] - 1;
                INFO("from " << height << " m, slope " << slope << ", channel " << c << ": " << off);
                CHECK(std::fabs(off) < 0.005);
                worst = std::max(worst, std::fabs(off));
            }
        }
        fmt::print("depth by the formula, layer at {} m: off by at most {:.2f}%\n", air.layer_center, 100 * worst);
    }
}
