// Checks of 05.pcf: maps with known depths, and how many texels were read.
#include "05_shadow_maps/truth.h"
#include "common/check/check.h"

using namespace lightwalk;

CHECK_EXERCISE("05.pcf", "begin at floor(uv * texels - kernel / 2), advance by two texels, and weight the outer ones") {
    for (const int field : {1, 3, 2}) {
        Probe probe{
            .include = "../tests/05_shadow_maps/known_map.glsl",
            .signature = "vec3 check_pcf_counted(vec2 uv, float depth, vec2 slope, int kernel)",
            .truth =
                [field](std::span<const double> in) {
                    const int kernel = static_cast<int>(in[5]);
                    return Row{truth::pcf(field, {in[0], in[1]}, in[2], {in[3], in[4]}, kernel),
                               double((kernel + 1) * (kernel + 1)), 0};
                },
            .bound = {.absolute = 2e-3},
            .macros = {{"FIELD", std::to_string(field)}},
            .words = [](const std::string& name, std::span<const double> v) -> std::string {
                if (!name.empty() || v.size() != 3) return "";
                return number_text(v[0]) + " from " + number_text(v[1]) + " gathered and " + number_text(v[2]) +
                       " single texels";
            },
            .hint = [field](auto in, auto got) -> std::string {
                const int kernel = static_cast<int>(in[5]);
                if (std::fabs(got[0] - truth::pcf(field, {in[0], in[1]}, in[2], {in[3], in[4]}, kernel)) < 2e-3)
                    return "the result is right; but gather each texel once, and read none singly";
                if (field == 2) return "the map holds the very plane of the surface: compare plane_depths()";
                if (in[2] == 0.75 || in[2] == 0.25)
                    return "a texel as deep as the surface is not in the way: only what is greater is";
                if (std::fabs(in[3]) + std::fabs(in[4]) > 1)
                    return "beyond the far plane the surface's depth counts as 0, not as less: nothing is in the way";
                if (kernel == 1) return "with a kernel of 1 four texels count, each by the part that is covered";
                return field == 1 ? "the map is near for u below 0.5: that part is in shadow" : "";
            }};
        Random random;
        for (const int kernel : {1, 3, 5, 9})
            for (int i = 0; i < 60; ++i) {
                // Away from the edges of texels, where rounding decides which of them the square touches.
                const auto place = [&] { return (20 + i % 24 + random.uniform(0.05, 0.95)) / 64; };
                const double u = static_cast<float>(place()), v = static_cast<float>(place());
                if (field == 2)
                    probe.inputs.push_back({u, v, static_cast<float>(0.5 + 0.3 * (u - 0.5) - 0.2 * (v - 0.5) + 1e-4),
                                            static_cast<float>(0.3), static_cast<float>(-0.2), double(kernel)});
                else
                    probe.inputs.push_back({u, v, 0.5, 0, 0, double(kernel)});
            }
        for (const int kernel : {1, 3, 5, 9})
            for (const double place : {0.41015625, 0.51953125, 0.60546875}) {
                if (field == 2) continue;
                for (const double depth : {0.75, 0.25})
                    probe.inputs.push_back({place, place + 1.0 / 256, depth, 0, 0, double(kernel)});
                // At the map's edge, beyond which there is nothing, on a plane that ends there: steep, so that no
                // texel's middle is near to a depth of the map.
                probe.inputs.push_back({63.3125 / 64, place, 0.5, -64, 0, double(kernel)});
                probe.inputs.push_back({place, 0.6875 / 64, 0.5, 0, 64, double(kernel)});
            }
        const Table results = check.probe(probe);
        check.property(probe, results, "but it must be between 0 and 1",
                       [](auto, auto out) { return out[0] >= 0 && out[0] <= 1 + 1e-5; });
    }
}
