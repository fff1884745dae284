// Preetham module: the sky of a clear day from a formula. Knobs and GLSL, no pass.
#pragma once
#include "common/app/module.h"

namespace lightwalk {

/// A pass that states it in `.with` includes 10_atmosphere/preetham_inputs.glsl and calls
///
///     vec3 sky_light(vec3 direction, vec3 to_sun)   // linear light of the sky, much as the horizon's below it
///     vec3 sun_light(vec3 to_sun)                   // irradiance of a surface that faces the sun
///
/// with directions of unit length, +y up. For an eye near the ground: it ignores heights and distances.
struct Preetham : Module {
    Preetham(Module& owner, std::string name) : Module(owner, std::move(name), "preetham") {}

    Knob<float> turbidity{
        *this, "turbidity", 2.5f, {1.7f, 10.0f}, "Turbidity of the air: 2 very clear, 3 clear, 6 moist, 10 haze"};
    Knob<float> exposure{*this, "exposure", 0.1f, {0.0f, 1e3f}, "Exposure: scale factor for luminance in kcd/m²"};
    Knob<float> sun{*this, "sun", 128.0f, {0.0f, 1e4f}, "Illuminance of the sun outside of the air", "klx"};
};

}  // namespace lightwalk
