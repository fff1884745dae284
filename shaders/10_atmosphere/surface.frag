// Mountains that stand on the planet: rock, grass and snow by height and slope, under the sun and the sky.
#include "10_atmosphere/ground_light.glsl"
#include "10_atmosphere/view_path.glsl"

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;
layout(scalar) uniform SunBlock { vec3 to_sun; };
layout(scalar) uniform PlanetBlock { float snow_m; } planet;

layout(location = 0) out vec4 color;

void main() {
    Path here = path_from(world_position, to_sun, to_sun);
    if (here.height < 0.0) discard;  // under the sea
    vec3 normal = normalize(world_normal), up = normalize(world_position + vec3(0.0, air.radius, 0.0));
    float flatness = dot(normal, up);
    float grain = sin(0.013 * world_position.x + 3.0 * sin(0.007 * world_position.z)) * sin(0.011 * world_position.z);
    float snow = smoothstep(-350.0, 250.0, here.height - planet.snow_m + 180.0 * grain) * smoothstep(0.55, 0.8, flatness);
    float grass = smoothstep(0.72, 0.92, flatness + 0.05 * grain);
    vec3 albedo = mix(mix(vec3(0.16, 0.13, 0.11), vec3(0.07, 0.10, 0.035), grass), vec3(0.8, 0.82, 0.85), snow);
    albedo = mix(vec3(0.35, 0.3, 0.22), albedo, smoothstep(2.0, 14.0, here.height));  // a beach
    Place place = Place(here.height, here.sun);
    vec3 light = sunlight_on(place) * max(dot(normal, to_sun), 0.0) + skylight_on(place) * (0.5 + 0.5 * flatness);
    color = vec4(albedo / 3.14159265 * light, 1.0);
}
