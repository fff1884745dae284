// Dark metal in the valleys, which glow with the music, and bright metal on the peaks.
#include "14_environment/beat_surface.glsl"
#include "14_environment/unoccluded.glsl"
#include "common/structs.h"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float raised;
layout(location = 0) out vec4 color;

layout(scalar) uniform ViewBlock { CameraView view; };
layout(scalar) uniform BeatLookBlock {
    vec3 valley, peak, glow;
    float roughness;
} beat_look;

void main() {
    vec3 n = normalize(normal), to_eye = normalize(view.eye - position);
    float most = max(dot(beat_now.heights, vec3(1.0)), 1e-6), share = raised / most;
    float moved = smoothstep(0.0, 0.15, most);
    // Mountains around a valley hide part of the surroundings: a rule of thumb.
    float open = mix(1.0, 0.3 + 0.7 * smoothstep(0.0, 0.35, share), moved);

    vec3 f0 = mix(beat_look.valley, beat_look.peak, smoothstep(0.0, 0.4, share));
    float alpha = beat_look.roughness * beat_look.roughness;
    FromAround around = reflected_from_around(LitFromAround(position, n, to_eye, f0, alpha, Blend(1.0, f0, f0)));
    vec3 light = open * around.specular + moved * beat_now.glow * exp(-30.0 * share) * beat_look.glow;
    color = vec4(min(light, LARGEST_HALF), 1.0);
}
