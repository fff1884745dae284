// Occlusion for each pixel from those in which it was sought: the mean over the 4x4 of the noise, of one surface.
#include "14_environment/occlusion_step.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D found;
layout(rgba16f) writeonly uniform image2D wide;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy), small = textureSize(found, 0);
    if (any(greaterThanEqual(pixel, imageSize(wide)))) return;
    float stored = stored_at(pixel);
    if (stored <= 0.0) {
        imageStore(wide, pixel, vec4(0.0, 0.0, 0.0, 1.0));
        return;
    }
    // 1/distance is linear in the picture on a plane: what two steps foretell is the same surface.
    float per_metre = depth_to_per_metre(stored, occlusion_step.rays.inverse_near, occlusion_step.rays.inverse_far);
    vec2 at = (vec2(pixel) + 0.5) / occlusion_step.shrink - 0.5;
    ivec2 first = ivec2(floor(at)) - 1;
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) {
            ivec2 place = clamp(first + ivec2(x, y), ivec2(0), small - 1);
            float other = stored_at(ivec2(vec2(place) * occlusion_step.shrink));
            if (other <= 0.0) continue;
            float theirs =
                depth_to_per_metre(other, occlusion_step.rays.inverse_near, occlusion_step.rays.inverse_far);
            float weight = max(1.0 - 20.0 * abs(theirs / per_metre - 1.0), 1e-4);
            sum += weight * texelFetch(found, place, 0);
            weights += weight;
        }
    imageStore(wide, pixel, weights > 0.0 ? sum / weights : vec4(0.0, 0.0, 0.0, 1.0));
}
