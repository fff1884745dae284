// Alpha scaling of one mip, so that as large a share passes the test as in level 0; one workgroup.
layout(local_size_x = 256) in;

layout(rgba32f) uniform image2D level;
layout(scalar) uniform CutoutBlock {
    float cutoff;
    float wanted;  // share in level 0
} cutout;

// Interface of alpha_scale.glsl.
const uint LEVEL_INVOCATIONS = 256u;

ivec2 place_of(uint texel) { return ivec2(texel % uint(imageSize(level).x), texel / uint(imageSize(level).x)); }
uint level_texels() { return uint(imageSize(level).x * imageSize(level).y); }
float level_alpha(uint texel) { return imageLoad(level, place_of(texel)).a; }
bool is_kept(float alpha) { return round(255.0 * min(alpha, 1.0)) / 255.0 >= cutout.cutoff; }

#include "04_surface_maps/alpha_scale.glsl"

shared uint passing, tied;
shared uint least[2], most[2];  // alphas of what is lost and what is kept, as bits

bool is_tied(float alpha) { return abs(alpha - cutout.cutoff) < 1.5 / 255.0; }

// Ordered dither of 4 × 4, 0 to 1 (B. E. Bayer 1973).
float pattern(ivec2 place) {
    ivec2 a = place & 1, b = place >> 1 & 1;
    return (float(4 * (2 * (a.x ^ a.y) + a.y) + 2 * (b.x ^ b.y) + b.y) + 0.5) / 16.0;
}

void main() {
    uint local = gl_LocalInvocationIndex;
    float scale = alpha_scale(local, cutout.cutoff, cutout.wanted), all = float(level_texels());
    if (local == 0u) {
        passing = tied = most[0] = most[1] = 0u;
        least[0] = least[1] = floatBitsToUint(1e30);
    }
    barrier();  // before any alpha changes, too
    for (uint i = local; i < level_texels(); i += LEVEL_INVOCATIONS) {
        float alpha = level_alpha(i) * scale;
        if (is_tied(alpha)) atomicAdd(tied, 1u);
        if (!is_tied(alpha) && is_kept(alpha)) atomicAdd(passing, 1u);
        uint side = is_kept(alpha) ? 1u : 0u;
        atomicMin(least[side], floatBitsToUint(alpha));
        atomicMax(most[side], floatBitsToUint(alpha));
    }
    barrier();

    // 1. Where most of a level has one alpha, no scale keeps a share of it: a pattern does.
    float missing = cutout.wanted * all - float(passing), share = missing / max(float(tied), 1.0);
    float lost = min(missing, float(tied) - missing);  // by keeping all of these or none
    bool divides = all >= 16.0 && lost > 0.5 * min(cutout.wanted, 1.0 - cutout.wanted) * all;

    // 2. Where a level has two alphas, the cutoff is half way, so that neither grows between texels.
    float low = uintBitsToFloat(least[0]), high = uintBitsToFloat(least[1]);
    bool has_two = low > 0.0 && most[0] > 0u && most[1] > 0u && uintBitsToFloat(most[0]) - low < 1.5 / 255.0 &&
                   uintBitsToFloat(most[1]) - high < 1.5 / 255.0;
    if (has_two && !divides) scale *= 2.0 * cutout.cutoff / (low + high);
    for (uint i = local; i < level_texels(); i += LEVEL_INVOCATIONS) {
        vec4 texel = imageLoad(level, place_of(i));
        float alpha = texel.a * scale;
        if (divides && is_tied(alpha)) alpha = cutout.cutoff * (pattern(place_of(i)) < share ? 1.1 : 0.9);
        imageStore(level, place_of(i), vec4(texel.rgb, min(1.0, alpha)));
    }
}
