// Tone curves in double precision.
#pragma once
#include <string>

#include "09_post_effects/aces_truth.h"

namespace lightwalk::truth {

/// K. Narkowicz, 2015, without the clamp.
inline double narkowicz(double x) { return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14); }

/// S. Hill, 2016: the curve between his matrices, and all three steps, clamped or not.
inline double hill_curve(double v) {
    return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
}
inline glm::dvec3 hill(glm::dvec3 c, bool clamped = true) {
    const glm::dmat3 in(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
    const glm::dmat3 out(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
    const glm::dvec3 v = in * c;
    const glm::dvec3 shown = out * glm::dvec3(hill_curve(v.r), hill_curve(v.g), hill_curve(v.b));
    return clamped ? glm::clamp(shown, 0.0, 1.0) : shown;
}

/// Khronos PBR neutral, 2024.
inline glm::dvec3 neutral(glm::dvec3 c) {
    const double least = std::min({c.r, c.g, c.b});
    c -= least < 0.08 ? least - 6.25 * least * least : 0.04;
    const double peak = std::max({c.r, c.g, c.b}), start = 0.76;
    if (peak < start) return c;
    const double shown = 1 - (1 - start) * (1 - start) / (peak + 1 - 2 * start);
    const double white = 1 - 1 / (0.15 * (peak - shown) + 1);
    return c * (shown / peak) * (1 - white) + glm::dvec3(shown * white);
}

/// T. Sobotka's AgX by B. Wrensch's fit, 2023.
inline glm::dvec3 agx(glm::dvec3 c) {
    const glm::dmat3 in(0.842479062253094, 0.0423282422610123, 0.0423756549057051, 0.0784335999999992,
                        0.878468636469772, 0.0784336, 0.0792237451477643, 0.0791661274605434, 0.879142973793104);
    const glm::dmat3 out(1.19687900512017, -0.0528968517574562, -0.0529716355144438, -0.0980208811401368,
                         1.15190312990417, -0.0980434501171241, -0.0990297440797205, -0.0989611768448433,
                         1.15107367264116);
    glm::dvec3 v = in * c;
    for (int i = 0; i < 3; ++i) {
        const double x = (std::clamp(std::log2(std::max(v[i], 1e-10)), -12.47393, 4.026069) + 12.47393) / 16.499999;
        const double coefficients[] = {-0.00232, 0.1191, 0.4298, -6.868, 31.96, -40.14, 15.5};
        v[i] = 0;
        for (int power = 6; power >= 0; --power) v[i] = v[i] * x + coefficients[power];
    }
    v = glm::clamp(out * v, 0.0, 1.0);
    return glm::pow(v, glm::dvec3(2.2));
}

/// By the module's name of it; light below 0 counts as 0.
inline glm::dvec3 tone(const std::string& name, glm::dvec3 radiance) {
    const glm::dvec3 c = glm::clamp(radiance, 0.0, 65504.0);
    if (name == "clamp") return glm::min(c, glm::dvec3(1));
    if (name == "reinhard") return c / (1.0 + c);
    if (name == "film") return 1.0 - glm::exp(-c);
    if (name == "narkowicz") return glm::clamp(glm::dvec3(narkowicz(c.r), narkowicz(c.g), narkowicz(c.b)), 0.0, 1.0);
    if (name == "hill") return hill(c);
    if (name == "neutral") return neutral(c);
    if (name == "agx") return agx(c);
    if (name == "aces") return reference_tone(c);
    return radiance;
}

}  // namespace lightwalk::truth
