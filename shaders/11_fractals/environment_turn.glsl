// How a pass turns directions into the space of the environment's picture.
#include "11_fractals/environment_data.h"

layout(scalar) uniform EnvironmentScaleBlock { EnvironmentScale environment_scale; };

// From world space to the picture's.
vec3 environment_space(vec3 direction) {
    vec2 xz = mat2(environment_scale.cosine, environment_scale.sine, -environment_scale.sine, environment_scale.cosine) *
              direction.xz;
    return vec3(xz.x, direction.y, xz.y);
}
