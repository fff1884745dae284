// The air before a picture, from tables. An eye in the air: the sky's table, and the volume for what is near. What is
// farther than the volume, and all that is seen from space, is marched with the light that the tables know.
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/sun_table.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/sky_view.glsl"

uniform sampler2D air_sky;
uniform sampler3D air_light, air_through;
layout(scalar) uniform ReachBlock { vec3 reach; };  // the picture's size in pixels; how far the last slice is, 0: no volume

// [along]
Along along(Path path, vec3 direction, ivec2 pixel, float distance) {
    bool in_air = reach.z > 0.0;
    if (in_air && distance <= reach.z) {
        vec3 size = vec3(textureSize(air_light, 0));
        vec3 at = vec3((vec2(pixel) + 0.5) / reach.xy, sqrt(distance / reach.z));
        at = (0.5 + at * (size - 1.0)) / size;
        return Along(textureLod(air_light, at, 0.0).rgb, textureLod(air_through, at, 0.0).rgb);
    }
    if (in_air && distance >= endless) {
        vec2 size = vec2(textureSize(air_sky, 0));
        float sine = sqrt(max(1.0 - path.slope * path.slope, 0.0)), sun_sine = sqrt(max(1.0 - path.sun * path.sun, 0.0));
        float cosine = (path.cos_angle - path.slope * path.sun) / max(sine * sun_sine, 1e-5);
        vec2 at = sky_at(elevation_of(path.slope), acos(clamp(cosine, -1.0, 1.0)), path.height);
        vec3 light = textureLod(air_sky, (0.5 + at * (size - 1.0)) / size, 0.0).rgb;
        return Along(light, read_transmittance(path.height, path.slope));
    }
    return in_scatter(path, atmosphere.samples);
}
// [/along]

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(result)))) look(pixel);
}
