// Air around a body: chapter 10's single scattering, from outside and from within.
#include "10_atmosphere/in_scatter.glsl"
#include "10_atmosphere/sun_closed.glsl"
#include "common/light.glsl"

// The part in the air of a ray from `from` (from the body's centre, where the body is a sphere) along `direction`, for at most
// `way` metres. It begins where the ray enters the air, or at the camera in it; its length is 0 if the ray misses the air.
Path air_path(vec3 from, vec3 direction, vec3 to_sun, float way) {
    float along = -dot(from, direction), top = air.radius + air.top;
    vec3 nearest = from + along * direction;
    float b = length(nearest), half_chord = sqrt(max((top - b) * (top + b), 0.0));
    float enters = max(along - half_chord, 0.0), leaves = min(along + half_chord, way);
    if (b >= top || leaves <= enters) return Path(0.0, 0.0, 0.0, 0.0, 0.0);
    vec3 start = from + enters * direction;
    float r = length(start);
    return Path(max(r - air.radius, 0.0), dot(start, direction) / r, dot(start, to_sun) / r, dot(direction, to_sun),
                leaves - enters);
}

Along air_before(vec3 from, vec3 direction, vec3 to_sun, float way, int samples) {
    Path path = air_path(from, direction, to_sun, way);
    if (path.way <= 0.0) return Along(vec3(0.0), vec3(1.0));
    return in_scatter(samples, path);
}

// Single scattering alone is red under a low sun. Multiply scattered light there is blue, from the sunlit air around,
// and both together are nearly grey: towards the terminator the colour fades.
vec3 with_more_orders(vec3 light, float sun_cosine) {
    float grey = luminance(light);
    return mix(light, grey * vec3(0.95, 0.99, 1.15), 0.85 * (1.0 - smoothstep(-0.05, 0.3, sun_cosine)));
}

vec3 sunlight_at(float sun_cosine) { return sun_transmittance(Place(0.0, sun_cosine)); }
