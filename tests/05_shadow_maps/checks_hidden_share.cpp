// Checks of 05.hidden_share.
#include "05_shadow_maps/ray_truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("05.hidden_share", "the overlap of two discs is two segments: where does the chord between them lie?") {
    Probe probe{.include = "05_shadow_maps/hidden_share.glsl",
                .signature = "float hidden_share(float radius, float gap)",
                .truth = [](auto in) -> Row { return {truth::hidden_share(in[0], in[1])}; },
                .bound = {.absolute = 2e-3},
                .hint = [](auto in, auto) -> std::string {
                    if (in[1] >= 1) return "the discs do not meet";
                    if (in[0] + in[1] <= std::fabs(1 - in[0]))
                        return in[0] < 1 ? "all of the planet is in front of the sun, and hides its own area"
                                         : "nothing of the sun is seen";
                    if (in[0] > 100)
                        return "the planet's edge is nearly straight here: what does the sun's segment say?";
                    return "two segments: of the sun beyond the chord, and of the planet on the chord's other side";
                }};
    for (const double radius : {0.0, 0.1, 0.5, 0.999, 1.0, 1.001, 2.0, 16.0, 100.0, 1e3, 1e4, 1e6})
        for (const double gap : {-1e6, -1000.5, -1.0, -0.99, -0.5, 0.0, 0.5, 0.99, 1.0, 2.0, 1e6})
            if (gap >= -radius) probe.inputs.push_back({radius, gap});
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const double radius = random.logarithmic(0.05, 1e5);
        probe.inputs.push_back({radius, random.uniform(std::max(-radius, -1.5), 1.5)});
    }
    for (Row& row : probe.inputs)
        for (double& number : row) number = double(float(number));
    const Table results = check.probe(probe);
    check.property(probe, results, "but a share is from 0 to 1",
                   [](auto, auto out) { return out[0] >= -1e-4 && out[0] <= 1.0001; });
}
