// Parameters of the stages: the module's knobs and values of each frame.
#include "09_post_effects/post_now.h"

layout(scalar) uniform PostBlock {
    float stops;
    float contrast_by, brightness_by, saturation_by, greyscale_by, invert_by;
    float vignette_strength, vignette_power;
    float scan_strength, scan_lines;
    vec3 fade_color;
    float fade_by;
    float gamma_by;
    float grain_by;
    float blur_by;
    int blur_taps;
    vec3 aberration_shift;
    float aberration_rows;
    float sharpen_by;
    int codes;
} post;
layout(scalar) uniform PostNowBlock { PostNow post_now; };
