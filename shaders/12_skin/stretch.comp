// How the map lies on the surface: texels per mm along u and v, mm² in a texel, and how curved it is there, in 1/mm.
#include "12_skin/chart_step.glsl"
#include "12_skin/charts.glsl"
#include "12_skin/stretch_scale.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D skin_normal;
layout(rgba16f) writeonly uniform image2D result;
layout(scalar) uniform MostBlock { float most_texels; };

// How far the normal turns over about 1.5 mm to each side.
float curvature(ivec2 texel, ivec2 direction, float per_mm, vec4 own) {
    ivec2 reach = max(int(1.5 * per_mm), 1) * direction;
    vec4 before = place_at(texel - reach), after = place_at(texel + reach);
    if (before.w != own.w || after.w != own.w) return 0.0;
    vec3 turned = texelFetch(skin_normal, texel + reach, 0).xyz - texelFetch(skin_normal, texel - reach, 0).xyz;
    return length(turned) / max(1000.0 * length(after.xyz - before.xyz), 1e-3);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(result)))) return;
    vec4 own = place_at(texel);
    vec4 found = vec4(0.0);
    if (own.w > 0.0) {
        vec3 du = chart_step(place_at(texel - ivec2(1, 0)), own, place_at(texel + ivec2(1, 0)));
        vec3 dv = chart_step(place_at(texel - ivec2(0, 1)), own, place_at(texel + ivec2(0, 1)));
        vec2 per_mm = stretch_scale(du, dv, most_texels);
        float bend = 0.5 * (curvature(texel, ivec2(1, 0), per_mm.x, own) + curvature(texel, ivec2(0, 1), per_mm.y, own));
        found = vec4(per_mm, length(cross(du, dv)), bend);
    }
    imageStore(result, texel, found);
}
