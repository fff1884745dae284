// The reference's two series, for arguments lost to float rounding.
#include "volume_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(DeviceTest, "opacities near 0 become depths and back to the last digits of a float") {
    Probe probe{.include = "16_volume/exact.glsl",
                .before =
                    "#define VOLUME_METHOD 1\n#define VOLUME_METHOD_EXACT 1\n#define TRANSFER_TEXELS 256\n"
                    "const float REFERENCE_M = 0.01;\nstruct { float brightest; } volume_now;\n"
                    "float exact_density_at(vec3 at) { return 0.0; }\n"
                    "vec4 exactly_classified(float density) { return vec4(0.0); }\n"
                    "vec3 radiance_at(vec3 at, vec3 along, vec3 color) { return color; }\n",
                .signature = "float depth_of_opacity(float opacity)",
                .truth = [](auto in) { return Row{-std::log1p(-in[0])}; },
                .bound = {.relative = 1e-6}};
    Probe back = probe;
    back.signature = "float opacity_of_depth(float depth)";
    back.truth = [](auto in) { return Row{-std::expm1(-in[0])}; };
    for (const double x : {1e-9, 1e-7, 1e-5, 1e-3, 0.004, 0.012, 0.0199}) {
        probe.inputs.push_back({double(float(x))});
        back.inputs.push_back({double(float(x))});
    }
    CHECK(worst_of(probe, run_probe(gpu, probe, 1)) == "");
    CHECK(worst_of(back, run_probe(gpu, back, 1)) == "");
    // Beyond the series the plain formulas keep five digits.
    for (Probe* one : {&probe, &back}) {
        one->bound = {.relative = 1e-5};
        one->inputs = {{double(0.0201f)}, {double(0.1f)}, {0.5}, {double(0.99f)}};
        CHECK(worst_of(*one, run_probe(gpu, *one, 1)) == "");
    }
}
