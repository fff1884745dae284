// Gathers the discs of other pixels: one image for the background, one for the foreground.
#include "09_post_effects/dof_disc.glsl"
#include "09_post_effects/noise.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar) uniform DofBlock { int taps; } dof;
uniform sampler2D half_picture;
uniform sampler2D reached;
layout(rgba16f) writeonly uniform image2D far_field;
layout(rgba16f) writeonly uniform image2D near_field;

vec4 read(vec2 texel) { return textureLod(half_picture, texel / vec2(textureSize(half_picture, 0)), 0.0); }

// 1 where a disc of that diameter in pixels covers a place so many half texels away from its middle.
float covers(float disc_px, float away) { return clamp(0.25 * disc_px - away + 0.5, 0.0, 1.0); }

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(far_field)))) return;
    vec2 middle = vec2(at) + 0.5;
    vec4 own = read(middle);
    float turn = 3.14159265 * noise_of(uvec2(at), 0u);
    vec2 widest = texelFetch(reached, at / 8, 0).rg;

    // Background: discs that reach this pixel, no wider than its own. Each spreads its light over its disc.
    vec4 behind = vec4(own.rgb, 1.0);
    if (own.a > 1.0) {
        float radius = 0.25 * own.a;
        behind = vec4(0.0);
        for (int i = 0; i < dof.taps; ++i) {
            vec2 offset = radius * on_disc(i, dof.taps, turn);
            vec4 other = read(middle + offset);
            behind += covers(min(other.a, own.a), length(offset)) * vec4(other.rgb, 1.0);
        }
        if (behind.a > 0.0) behind /= behind.a;
        else behind = vec4(own.rgb, 1.0);
    }
    imageStore(far_field, at, behind);

    // Foreground: any disc that reaches here covers a share of this pixel.
    vec4 front = vec4(0.0);
    if (widest.x > 1.0) {
        float radius = 0.25 * widest.x + 0.5;
        for (int i = 0; i < dof.taps; ++i) {
            vec2 offset = radius * on_disc(i, dof.taps, turn);
            vec4 other = read(middle + offset);
            float disc = max(-0.25 * other.a, 0.5);
            float share = radius * radius / (disc * disc * float(dof.taps));  // of its light, in one tap's area
            if (other.a < -0.5) front += covers(-other.a, length(offset)) * share * vec4(other.rgb, 1.0);
        }
        if (front.a > 1.0) front /= front.a;
    }
    imageStore(near_field, at, front);
}
