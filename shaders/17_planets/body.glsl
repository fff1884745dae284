// A body as seen by a ray. Macros select its parts: BODY_AIR, BODY_EARTH (oceans, clouds, cities), BODY_FLOW,
// BODY_RINGS, BODY_STAR.
#include "17_planets/air_shell.glsl"
#include "17_planets/body_inputs.glsl"
#include "17_planets/clouds.glsl"
#include "17_planets/earth_air.glsl"
#include "17_planets/ellipsoid_shadow.glsl"
#include "17_planets/ground.glsl"
#include "17_planets/map_lookup.glsl"
#include "17_planets/parallax.glsl"
#include "17_planets/rings.glsl"
#include "17_planets/sun_surface.glsl"

#ifdef BODY_STAR
vec3 seen_surface(vec3 round_at, vec3 to_eye, vec3 to_sun, float pixel_m) {
    vec3 up = normalize(round_at);
    float mu = max(dot(up, to_eye), 0.0);
    return body.sunlight * sun_surface(up, mu, body.moment, footprint_of(pixel_m, body.radius, mu));
}
#endif

// A ray in the body's axes, where the camera stands at `eye`; and in round space, where the body is a sphere.
struct BodyRay {
    vec3 direction;    // unit length, the body's axes
    vec3 round_eye, round_direction;  // unit length; from the body's centre
    float stretch;     // metres of round space for a metre of the ray
    float nearest;     // way in round space to the point nearest to the centre
    vec3 nearest_at;   // that point
};

vec3 to_round(vec3 v) { return vec3(v.x, v.y / (1.0 - body.flattening), v.z); }

BodyRay body_ray(vec3 direction) {
    BodyRay ray;
    ray.direction = body.to_body * direction;
    vec3 round_way = to_round(ray.direction);
    ray.stretch = length(round_way);
    ray.round_eye = to_round(body.to_body * -body.center);
    ray.round_direction = round_way / ray.stretch;
    ray.nearest = -dot(ray.round_eye, ray.round_direction);
    ray.nearest_at = ray.round_eye + ray.nearest * ray.round_direction;
    return ray;
}

// Premultiplied light and alpha of a ray of unit length through a pixel of that angle.
vec4 seen_body(vec3 direction, float pixel_rad) {
    BodyRay ray = body_ray(direction);
    vec3 to_sun = body.to_body * body.to_sun;
    float b = length(ray.nearest_at), pixel_m = max(ray.nearest, 0.0) * pixel_rad;
    bool inside = dot(ray.round_eye, ray.round_eye) < body.radius * body.radius;

    // The surface; at the limb as much of it as a pixel covers.
    float covered = inside || ray.nearest <= 0.0 ? 0.0 : clamp(0.5 + (body.radius - b) / max(pixel_m, 1e-3 * body.radius * pixel_rad), 0.0, 1.0);
    float half_chord = sqrt(max((body.radius - b) * (body.radius + b), 0.0)), way = ray.nearest - half_chord;
    vec4 light = vec4(0.0);
    if (covered > 0.0) {
        vec3 at = (ray.round_eye + way * ray.round_direction) * (b > body.radius ? body.radius / b : 1.0);
#if !defined(BODY_STAR) && PLANETS_PARALLAX != PLANETS_PARALLAX_NONE
        if (body.surface.relief > 0.0) {
            float footprint_rad = footprint_of(max(way, 0.0) / ray.stretch * pixel_rad, body.radius, half_chord / body.radius);
            way = ground_way(ray.round_eye, ray.round_direction, ray.nearest, b, footprint_rad);
            at = body.radius * normalize(ray.round_eye + way * ray.round_direction);
        }
#endif
        light = covered * vec4(seen_surface(at, -ray.direction, to_sun, max(way, 0.0) / ray.stretch * pixel_rad), 1.0);
    }
#ifdef BODY_AIR
    float end = covered > 0.5 ? way : 1e30;
#ifdef BODY_EARTH
    vec4 cloud = seen_clouds(ray.round_eye, ray.round_direction, end, to_sun, pixel_rad);
    light = cloud + (1.0 - cloud.a) * light;
    Along air_there = earth_air(ray.round_eye, ray.round_direction, to_sun, end, dot(normalize(ray.nearest_at), to_sun));
#else
    Along air_there = air_before(ray.round_eye, ray.round_direction, to_sun, end, planets.air_steps);
#endif
    light = vec4(light.rgb * air_there.transmittance + air_there.light,
                 1.0 - (1.0 - light.a) * dot(air_there.transmittance, vec3(1.0 / 3.0)));
#endif
#ifdef BODY_RINGS
    // The rings' plane is the same in round space.
    vec3 eye = body.to_body * -body.center;
    float t = abs(ray.direction.y) > 1e-7 ? -eye.y / ray.direction.y : -1.0;
    vec3 at = eye + t * ray.direction;
    if (t > 0.0 && dot(at.xz, at.xz) < body.rings.outer * body.rings.outer * 1.02) {
        // A pixel's footprint, in radii: longer where the rings are seen at a low angle along it.
        float slant = abs(dot(normalize(at.xz), ray.direction.xz)) / max(abs(ray.direction.y), 1e-3);
        vec4 ring = ring_light(body.rings, at, -ray.direction, to_sun, t * pixel_rad * sqrt(1.0 + slant * slant));
        ring.rgb *= body.sunlight * ellipsoid_shadow(at, vec3(0.0, 1.0, 0.0), body.radius, shadow_flattening(), to_sun, shadow_sun_rad());
        bool before = t * ray.stretch < way || covered == 0.0;
        light = before ? ring + (1.0 - ring.a) * light : light + (1.0 - covered) * ring;
    }
#endif
    return light;
}
