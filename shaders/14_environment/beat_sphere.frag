// Lacquer in the valleys, which glow with the music, and polished metal on the peaks.
#include "14_environment/beat_surface.glsl"
#include "common/structs.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float raised;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform BeatLookBlock {
    vec3 lacquer, metal, glow;
    float roughness;
} beat_look;

void main() {
    vec3 n = normalize(normal), to_eye = normalize(view.eye - position);
    float most = max(dot(beat_now.heights, vec3(1.0)), 1e-6);
    float peak = smoothstep(0.08, 0.5, raised / most) * smoothstep(0.0, 0.05, most);
    // What stands around a valley hides a part of the surroundings: a rule of thumb.
    float open = mix(1.0, mix(0.35, 1.0, smoothstep(0.0, 0.5, raised / most)), smoothstep(0.0, 0.2, most));

    vec3 f0 = mix(vec3(0.04), beat_look.metal, peak);
    float alpha = beat_look.roughness * beat_look.roughness;
    FromAround around = reflected_from_around(LitFromAround(position, n, to_eye, f0, alpha));
    vec3 below = (1.0 - peak) * beat_look.lacquer * around.diffuse_share * diffuse_light(position, n);
    float valley = 1.0 - smoothstep(0.0, 0.25, raised / most);
    vec3 light = open * (below + around.specular) + beat_now.glow * valley * valley * beat_look.glow;
    color = vec4(min(light, 65504.0), 1.0);
}
