// Single scattering in a ring against its integral over the depth.
#include "planets_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(DeviceTest, "light that a ring scatters once is the integral over its depth, on both sides",
                 "[17.single_scattering]") {
    for (const bool through : {false, true}) {
        Probe probe{.include = "17_planets/single_scattering.glsl",
                    .signature = through ? "float scattered_through(float depth, float mu0, float mu)"
                                         : "float scattered_back(float depth, float mu0, float mu)"};
        for (const double depth : {0.01, 0.5, 2.0, 4.0})
            for (const double mu0 : {0.1, 0.4, 0.9})
                for (const double mu : {0.15, 0.4, 0.8}) probe.inputs.push_back({depth, mu0, mu});
        const Table found = run_probe(gpu, probe, 1);
        for (size_t i = 0; i < found.size(); ++i) {
            const double depth = probe.inputs[i][0], mu0 = probe.inputs[i][1], mu = probe.inputs[i][2];
            double sum = 0;
            const int steps = 20000;
            for (int k = 0; k < steps; ++k) {
                const double at = (k + 0.5) / steps * depth;
                sum += std::exp(-at / mu0 - (through ? depth - at : at) / mu) * depth / steps;
            }
            INFO(depth << " " << mu0 << " " << mu << (through ? " through" : " back"));
            CHECK(found[i][0] == Approx(sum / (4 * mu)).epsilon(1e-3));
        }
    }
}
