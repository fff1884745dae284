// How maps of bodies are read: no row beyond the poles, and levels by what a pixel covers.
#include "planets_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(DeviceTest, "a map is read no nearer to its poles than half a texel of the level that is read") {
    // In place of a texel where it is asked for, in a map of 100 rows.
    Probe probe{.include = "common/srgb.glsl",
                .before =
                    "#define textureSize(map, level) ivec2(200, 100)\n"
                    "#define textureLod(map, at, level) vec4(at, level, 1.0)\n"
                    "#define sampler2D int\n"
                    "#include \"17_planets/map_lookup.glsl\"\n"
                    "vec3 read_at(vec2 uv, float footprint_rad) { return map_texel(0, uv, footprint_rad).xyz; }\n",
                .signature = "vec3 read_at(vec2 uv, float footprint_rad)",
                .inputs = {},
                .truth =
                    [](auto in) {
                        const double lod = std::max(std::log2(in[2] * 100 / glm::pi<double>()), 0.0);
                        const double edge = std::min(0.5 * std::exp2(std::ceil(lod)) / 100, 0.5);
                        return Row{in[0], std::clamp(in[1], edge, 1 - edge), lod};
                    },
                .bound = {.absolute = 1e-5, .relative = 1e-5}};
    for (const double v : {0.0, 0.001, 0.02, 0.3, 0.7, 0.99, 1.0})
        for (const double footprint : {1e-4, 0.05, 0.15, 0.4, 3.0, 9.0})
            for (const double u : {-0.2, 0.5, 1.0}) probe.inputs.push_back({u, v, footprint});
    CHECK(worst_of(probe, run_probe(gpu, probe, 3)) == "");
}
