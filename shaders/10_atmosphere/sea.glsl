// A sea's surface: waves too far to be seen one by one are a roughness, those near the eye tilt it.
#include "10_atmosphere/ground_light.glsl"
#include "10_atmosphere/in_scatter.glsl"
#include "common/schlick.glsl"

// The slope of the waves at a point (metres), without waves shorter than two pixels; `steep` is the standard
// deviation of all of them together, `rest` the part left for roughness.
vec2 wave_slope(vec2 at, float pixel_m, float steep, out float rest) {
    vec2 slope = vec2(0.0);
    float length_m = 2.3, angle = 0.4, shown = 0.0, all = 0.0;
    for (int i = 0; i < 9; ++i) {
        float keep = smoothstep(2.0, 8.0, length_m / pixel_m), share = 1.0 / sqrt(length_m);  // long waves are flatter
        vec2 along = vec2(cos(angle), sin(angle));
        slope += keep * share * cos(6.2831853 * fract(dot(at, along) / length_m) + 1.7 * float(i)) * along;
        shown += keep * keep * share * share;
        all += share * share;
        length_m *= 1.6;
        angle += 2.39996;
    }
    rest = steep * sqrt(1.0 - 0.8 * shown / all);
    return slope * steep * sqrt(1.6 / all);
}

// Fresnel reflectance of water; at grazing angles rough water shows the eye its near sides.
float water_fresnel(float cosine, float steep) {
    return schlick(max(cosine, 0.7 * steep), 0.02);
}

// Light from a sea of that albedo towards -direction. `up` is its normal, `tilted` that of the wave. C. Cox and W. Munk,
// Journal of the Optical Society of America 44(11), 1954: the slopes of waves are a Gaussian.
vec3 sea_light(Place place, vec3 up, vec3 tilted, vec3 direction, vec3 to_sun, float steep, vec3 albedo) {
    float to_eye = max(-dot(direction, tilted), 0.02), fresnel = water_fresnel(to_eye, steep);
    vec3 half_way = to_sun - direction;
    float across = dot(half_way, half_way) > 1e-8 ? dot(normalize(half_way), tilted) : 0.0;
    float tangent = 1.0 / max(across * across, 1e-4) - 1.0, variance = steep * steep;
    float slopes = exp(-tangent / (2.0 * variance)) / (6.2831853 * variance * max(across * across * across * across, 1e-4));
    float mirrored = water_fresnel(max(dot(normalize(half_way + 1e-6 * up), to_sun), 0.0), 0.0);
    vec3 glint = across > 0.0 ? sunlight_on(place) * mirrored * slopes / (4.0 * max(to_eye, steep)) : vec3(0.0);

    // The sky that it mirrors: a little higher than a mirror would, for the waves.
    vec3 mirror = reflect(direction, tilted);
    mirror = normalize(mirror + (max(0.0, 0.7 * steep - dot(mirror, up)) + 0.3 * steep) * up);
    Path path = Path(place.height, max(dot(mirror, up), 0.0), place.sun, dot(mirror, to_sun), 0.0);
    path.way = ray_sphere(path.height, path.slope, air.radius, air.top).y;
    vec3 sky = in_scatter(6, path).light;
    vec3 inside = albedo / 3.14159265 * (sunlight_on(place) * max(dot(up, to_sun), 0.0) + skylight_on(place));
    return glint + fresnel * sky + (1.0 - fresnel) * inside;
}
