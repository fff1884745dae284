// Textures of the ground: grass, forest, rock and snow, mixed by height and slope.
#include "15_terrain_water/height_blend.glsl"

uniform sampler2DArray materials;
uniform sampler2DArray material_bumps;

const int GRASS = 0, FOREST = 1, ROCK = 2, SNOW = 3;

struct LandSurface {
    vec3 albedo, normal;  // linear; unit length
    float occlusion;      // 1: the textures hide nothing of the sky
};

// A material at a place: albedo, height, and slopes along u and v.
struct Texel {
    vec3 albedo;
    float height;
    vec2 slope;
};

// [scales]
// Three scales: the texture itself, and its own heights 7 and 62 times as large, which no eye takes for a repetition.
Texel texel_of(int layer, vec2 uv_m, float tile_m, float footprint_m) {
    vec2 uv = uv_m / tile_m;
    float level = log2(max(footprint_m / tile_m * 512.0, 1.0));
    vec4 fine = textureLod(materials, vec3(uv, layer), level);
    float middle = textureLod(materials, vec3(uv / 7.13 + 0.37, layer), level - 2.8).a;
    float broad = textureLod(materials, vec3(uv / 61.7 + 0.71, 0), max(level - 5.9, 0.0)).a;
    // And once more turned and 2.6 times as large, where the middle scale says so: tiles do not line up.
    if (layer == GRASS) fine = mix(fine, textureLod(materials, vec3(mat2(0.31, 0.23, -0.23, 0.31) * uv + 0.2, layer), level - 1.4), smoothstep(0.35, 0.65, middle));
    vec2 slope = textureLod(material_bumps, vec3(uv, layer), level).rg - 0.5;
    slope += 0.6 * (textureLod(material_bumps, vec3(uv / 7.13 + 0.37, layer), level - 2.8).rg - 0.5);
    return Texel(fine.rgb * fine.rgb * (0.55 + 0.9 * middle) * (0.7 + 0.75 * broad), fine.a, slope);
}
// [/scales]

// How hard the rock is at a height, 0 to 1: beds some metres to tens of metres thick.
float bed_at(float height_m, float footprint_m) {
    float thick = textureLod(materials, vec3(height_m / 430.0, 0.37, ROCK), log2(max(footprint_m / 430.0 * 512.0, 4.0))).a;
    float thin = textureLod(materials, vec3(height_m / 83.0, 0.71, ROCK), log2(max(footprint_m / 83.0 * 512.0, 2.0))).a;
    return smoothstep(0.4, 0.6, 0.6 * thick + 0.4 * thin);
}

// Light and dark beds that bend with the land. Hard ones stand out as ledges: the slope of the wall's relief along y.
vec3 beds_of(vec3 position, float footprint_m, out float ledge) {
    float bent = position.y + 30.0 * textureLod(materials, vec3(position.xz / 1900.0, ROCK), 5.0).a;
    float step_m = max(0.7, footprint_m), bed = bed_at(bent, footprint_m);
    ledge = 3.0 * (bed_at(bent + step_m, footprint_m) - bed) / step_m;
    return mix(vec3(1.0), mix(vec3(0.3, 0.19, 0.16), vec3(1.9, 1.72, 1.5), bed), land.strata);
}

// Joints: the texture drawn out along y, as water runs down a wall.
float joint_at(vec2 uv_m, float footprint_m) {
    float bend = textureLod(materials, vec3(uv_m / 610.0, ROCK), 3.0).a;
    vec2 uv = vec2(uv_m.x + 15.0 * bend, uv_m.y) / vec2(260.0, 1500.0);
    return textureLod(material_bumps, vec3(uv, ROCK), log2(max(footprint_m / 260.0 * 512.0, 2.0))).r - 0.5;
}

// On a wall a texture that is laid on from above runs down in streaks: there it comes from the sides.
Texel rock_texel(vec3 position, vec3 normal, float footprint_m, out vec3 tilt) {
    vec3 share = pow(abs(normal), vec3(6.0));
    share /= share.x + share.y + share.z;
    Texel sum = Texel(vec3(0.0), 0.0, vec2(0.0));
    tilt = vec3(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        if (share[axis] < 0.02) continue;
        vec2 uv = axis == 0 ? position.zy : axis == 1 ? position.xz : position.xy;
        Texel one = texel_of(ROCK, uv, 42.0, footprint_m);
        if (land.strata > 0.0) {  // grain of decimetres, which a tile of 42 m is too coarse for
            float grain = textureLod(materials, vec3(uv.yx / 5.3, ROCK), log2(max(footprint_m / 5.3 * 512.0, 1.0))).a;
            one.albedo *= mix(1.0, 0.6 + 0.8 * grain, land.strata);
            one.slope *= mix(1.0, 0.4, land.strata);
            if (axis != 1) one.slope.x += 0.9 * land.strata * joint_at(uv, footprint_m);
        }
        sum.albedo += share[axis] * one.albedo;
        sum.height += share[axis] * one.height;
        vec3 along = axis == 0 ? vec3(0.0, one.slope.y, one.slope.x) : axis == 1 ? vec3(one.slope.x, 0.0, one.slope.y) : vec3(one.slope, 0.0);
        tilt += share[axis] * along;
    }
    if (land.strata > 0.0) {
        float ledge;
        sum.albedo *= beds_of(position, footprint_m, ledge);
        tilt.y += land.strata * ledge;
    }
    return sum;
}

// How much of each material is expected, by height, slope and a noise of hundreds of metres.
vec4 weights_of(vec3 position, vec3 normal, float patches) {
    float rock = smoothstep(land.rock_deg - 6.0, land.rock_deg + 6.0, degrees(acos(clamp(normal.y, -1.0, 1.0))) + 10.0 * (patches - 0.5));
    float level = position.y + 160.0 * (patches - 0.5);
    float snow = smoothstep(land.snow_m - 60.0, land.snow_m + 120.0, level) * smoothstep(0.55, 0.75, normal.y);
    float slope = 1.0 - normal.y;
    float woods = smoothstep(0.0, 0.3, land.forest * 1.3 - patches + 2.0 * slope);
    woods *= smoothstep(6.0, 30.0, position.y) * smoothstep(land.snow_m - 20.0, land.snow_m - 200.0, level);
    vec4 weights = vec4(1.0 - woods, woods, 0.0, 0.0) * (1.0 - rock);
    weights.z = rock;
    weights *= 1.0 - snow;
    weights.w = snow;
    return weights;
}

LandSurface land_surface(vec3 position, vec3 normal, float footprint_m) {
    float patches = textureLod(materials, vec3(position.xz / 2900.0, SNOW), log2(max(footprint_m / 2900.0 * 512.0, 1.0))).a;
    patches = clamp(0.5 + 1.8 * (patches - 0.5), 0.0, 1.0);
    vec4 weights = weights_of(position, normal, patches), heights = vec4(0.0);
    Texel texels[4];
    vec3 tilts[4], tint[4] = vec3[](land.grass_tint, land.forest_tint, land.rock_tint, vec3(1.0));
    float tiles[4] = float[](24.0, 74.0, 42.0, 30.0), depth[4] = float[](0.5, 1.3, 1.1, 0.3);
    for (int i = 0; i < 4; ++i) {
        tilts[i] = vec3(0.0);
        texels[i] = Texel(vec3(0.0), 0.0, vec2(0.0));
        if (weights[i] <= 0.0) continue;
        if (i == ROCK) {
            texels[i] = rock_texel(position, normal, footprint_m, tilts[i]);
        } else {
            texels[i] = texel_of(i, position.xz, tiles[i], footprint_m);
            tilts[i] = vec3(texels[i].slope.x, 0.0, texels[i].slope.y);
        }
        heights[i] = texels[i].height;
    }
#if LAND_BLEND == LAND_BLEND_HEIGHT_AWARE
    weights = height_blend(weights, heights, land.softness);
#endif
    LandSurface surface = LandSurface(vec3(0.0), vec3(0.0), 0.0);
    vec3 tilt = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        surface.albedo += weights[i] * tint[i] * texels[i].albedo;
        surface.occlusion += weights[i] * (i == SNOW ? 1.0 : 0.55 + 0.45 * texels[i].height);
        tilt += weights[i] * depth[i] * tilts[i];
    }
    // A shore of gravel.
    float shore = smoothstep(5.0, 1.0, position.y + 3.0 * (patches - 0.5)) * smoothstep(0.25, 0.1, 1.0 - normal.y);
    surface.albedo = mix(surface.albedo, vec3(0.16, 0.14, 0.11) * (0.7 + 0.6 * heights[0]), shore);
    surface.normal = normalize(normal - land.bumps * (1.0 - shore) * (tilt - dot(tilt, normal) * normal));
    return surface;
}
