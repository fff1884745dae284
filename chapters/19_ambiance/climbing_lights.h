// World of many lights, of which some climb a figure.
#pragma once
#include "06_deferred/many_lights.h"

namespace lightwalk {

// [climbing]
struct ClimbingLights : ManyLights {
    using ManyLights::ManyLights;
    Knob<int> climbers{*this, "climbers", 0, {0, 100000}, "Number of lights that climb a figure, besides all others"};
    Knob<glm::vec3> foot{
        *this, "foot", glm::vec3(0.0f), {glm::vec3(-1e4f), glm::vec3(1e4f)}, "Place where the figure stands", "m"};
    Knob<float> figure_m{*this, "figure_m", 1.8f, {0.01f, 1000.0f}, "Height that the lights climb to", "m"};
    Knob<float> girth_m{*this, "girth_m", 0.5f, {0.01f, 1000.0f}, "Distance of the lights from its axis, at the foot",
                        "m"};

  protected:
    LightList all_lights(const Frame& frame) override;
};
// [/climbing]

}  // namespace lightwalk
