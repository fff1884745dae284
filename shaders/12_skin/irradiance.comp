// Light entering the skin in each texel of the map: the radiance of a matt white surface.
#include "common/structs.h"
#include "03_attenuation/lighting.glsl"
#include "05_shadow_maps/shadow.glsl"
#include "common/environment.glsl"
#include "12_skin/charts.glsl"
#include "12_skin/mix_albedo.glsl"
#include "12_skin/skin.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D skin_normal, skin_albedo, skin_occlusion;
layout(rgba16f) writeonly uniform image2D result;

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy), size = imageSize(result);
    if (any(greaterThanEqual(texel, size))) return;
    vec4 place = place_at(texel), normal = texelFetch(skin_normal, texel, 0), albedo = texelFetch(skin_albedo, texel, 0);
    if (place.w == 0.0) {
        imageStore(result, texel, vec4(0.0));
        return;
    }
    float occlusion = textureLod(skin_occlusion, (vec2(texel) + 0.5) / vec2(size), 0.0).r;
    vec3 sum = occlusion * surroundings_light(normal.xyz);
    for (uint i = 0u; i < lights_data.length(); ++i) {
        VisibleLight light = visible_light(i, place.xyz, normal.xyz, normal.xyz);
        float cosine = dot(normal.xyz, light.to_light);
        if (cosine > 0.0)
            sum += light.visible * cosine * way_in(cosine, skin.roughness * normal.w, skin.specular_scale * albedo.a) * light.radiance;
    }
    imageStore(result, texel, vec4(min(sum * albedo_before(albedo.rgb, skin.before), LARGEST_HALF), place.w));
}
