// The air before a picture, from tables. An eye in the air: the sky's table, and the volume for near objects. Objects
// beyond the volume, and all views from space, are marched with light from the tables.
#include "10_atmosphere/look.glsl"
#include "10_atmosphere/sun_table.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/sky_view.glsl"

uniform sampler2D air_sky;
uniform sampler3D air_light, air_through;
layout(scalar) uniform ReachBlock { float reach_m; };  // how far the volume's last slice is; 0: there is none

Along near_by(vec2 pixel, float distance) {
    vec3 size = vec3(textureSize(air_light, 0)), at = vec3(pixel / vec2(imageSize(result)), sqrt(distance / reach_m));
    at = (0.5 + at * (size - 1.0)) / size;
    return Along(textureLod(air_light, at, 0.0).rgb, textureLod(air_through, at, 0.0).rgb);
}

Along sky(Path path) {
    vec2 size = vec2(textureSize(air_sky, 0));
    float sine = sqrt(max(1.0 - path.slope * path.slope, 0.0)), sun_sine = sqrt(max(1.0 - path.sun * path.sun, 0.0));
    float cosine = (path.cos_angle - path.slope * path.sun) / max(sine * sun_sine, 1e-5);
    vec2 at = sky_at(elevation_of(path.slope), acos(clamp(cosine, -1.0, 1.0)), path.height);
    vec3 light = textureLod(air_sky, (0.5 + at * (size - 1.0)) / size, 0.0).rgb;
    return Along(light, read_transmittance(path.height, path.slope));
}

Along along(Path path, vec3 direction, ivec2 pixel, float distance) {
    Along result;
    if (distance <= reach_m) {
        result = near_by(vec2(pixel) + 0.5, distance);
    } else if (reach_m > 0.0 && distance >= endless) {
        result = sky(path);
    } else {
        result = in_scatter(atmosphere.steps, path);
    }
    return result;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(pixel, imageSize(result)))) look(pixel);
}
