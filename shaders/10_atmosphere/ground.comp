// The ground of a planet where nothing stands before it, and the stars beyond the air, as they would look without it.
#include "10_atmosphere/map_uv.glsl"
#include "common/hash.glsl"
#include "common/structs.h"
#include "10_atmosphere/sea.glsl"
#include "10_atmosphere/view_path.glsl"
#include "common/view_rays.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f) writeonly uniform image2D result;
uniform sampler2D depth;
layout(scalar) uniform RaysBlock { ViewRays rays; };
layout(scalar) uniform SunBlock { vec3 to_sun; };
layout(scalar) uniform TurnBlock { mat3 to_map; };  // from the world to the map's axes
layout(scalar) uniform PlanetBlock {
    vec3 color;
    float sea, waves, clouds, night, stars;
} planet;
layout(scalar) uniform StrengthBlock { float strength; };  // of values in kcd/m²
uniform sampler2D star_map;
#if PLANET_MAP != PLANET_MAP_PLAIN
uniform sampler2D day_map;
#endif
#if PLANET_MAP == PLANET_MAP_EARTH
uniform sampler2D night_map, cloud_map, water_map;
#endif

// The level of detail comes from the pixel's size: across the date line neighbours' coordinates differ by 1.
vec4 map_texel(sampler2D map, vec3 direction, float pixel_rad) {
    float lod = log2(max(pixel_rad / 3.14159265 * float(textureSize(map, 0).y), 1e-6));
    return textureLod(map, map_uv(direction), max(lod, 0.0));
}

#if PLANET_MAP == PLANET_MAP_EARTH
// Districts of 3 km, bright and dark, with a mean of 1: a texel of the map of cities is 20 km wide.
float street_lights(vec3 on_map, float pixel_m) {
    float bright = hash3(ivec3(floor(on_map * (air.radius / 3000.0)))).x;
    return mix(1.0, 6.0 * pow(bright, 5.0), smoothstep(5000.0, 1200.0, pixel_m));
}
#endif

vec3 ground_light(vec3 point, vec3 direction, Place place, float pixel_m) {
    vec3 up = normalize(point + vec3(0.0, air.radius, 0.0)), on_map = to_map * up;
    float facing = max(-dot(direction, up), 0.05), pixel_rad = pixel_m / (air.radius * sqrt(facing));
    vec3 albedo = planet.color;
    float water = planet.sea, cloud = 0.0;
#if PLANET_MAP != PLANET_MAP_PLAIN
    albedo *= map_texel(day_map, on_map, pixel_rad).rgb;
#endif
#if PLANET_MAP == PLANET_MAP_EARTH
    water *= map_texel(water_map, on_map, pixel_rad).r;
    cloud = planet.clouds * map_texel(cloud_map, on_map, pixel_rad).r;
#endif
    vec3 sun = sunlight_on(place), sky = skylight_on(place);
    vec3 light = albedo / 3.14159265 * (sun * max(place.sun, 0.0) + sky);
    if (water > 0.01) {
        float rest;
        vec2 slope = wave_slope(point.xz, pixel_m / facing, planet.waves, rest);
        vec3 tilted = normalize(up - vec3(slope.x, 0.0, slope.y));
        light = mix(light, sea_light(place, up, tilted, direction, to_sun, rest, albedo), water);
    }
    light = mix(light, 0.75 / 3.14159265 * (sun * max(place.sun, 0.0) + sky), cloud);
#if PLANET_MAP == PLANET_MAP_EARTH
    float dark = smoothstep(0.02, -0.12, place.sun) * (1.0 - 0.8 * cloud);
    light += dark * planet.night * strength * street_lights(on_map, pixel_m) * map_texel(night_map, on_map, pixel_rad).rgb;
#endif
    return light;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(result))) || texelFetch(depth, pixel, 0).r > 0.0) return;
    vec3 ray = ray_through(rays, vec2(pixel) + 0.5), direction = normalize(ray);
    Path path = path_from(rays.eye, direction, to_sun);
    float t = distance_to_ground(path), pixel_rad = length(rays.right);
    vec3 light;
    if (t >= 0.0) {
        light = ground_light(rays.eye + t * direction, direction, Place(0.0, place_at(path, t).sun), t * pixel_rad);
    } else {
        light = planet.stars * strength * map_texel(star_map, direction, pixel_rad).rgb;
    }
    imageStore(result, pixel, vec4(min(light, LARGEST_HALF), 1.0));
}
