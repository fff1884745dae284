// The water surface in a pixel: its normal at the pixel's resolution, and the variance of finer detail.
#include "15_terrain_water/water_surface.glsl"
#include "15_terrain_water/waterline.glsl"

struct Facet {
    vec3 normal;     // towards the eye
    float cosine;    // of the angle between it and the eye, above 0
    float variance;  // of the slopes that are too fine to be seen, both axes
    float spacing;   // metres from one pixel to the next
    mat3 slopes;     // as 15.gerstner_normal sums them
};

// Calls dFdx().
Facet facet_at(vec2 at_rest, vec3 to_eye, bool below) {
    float spacing = max(length(dFdx(at_rest)), length(dFdy(at_rest)));
    WaterPoint p = water_at(at_rest, 0.5 * spacing);
    vec2 rings = ring_slope(at_rest + p.moved.xz, 0.5 * spacing);
    p.slopes[0].y += rings.x;
    p.slopes[2].y += rings.y;
    vec3 normal = gerstner_normal(p.slopes);
    if (below) normal = -normal;
    // A facet that is turned away shows its neighbour's front.
    float cosine = dot(normal, to_eye);
    if (cosine < 0.02) {
        normal = normalize(normal + (0.02 - cosine) * to_eye);
        cosine = 0.02;
    }
    return Facet(normal, cosine, p.hidden + 2.0 * water_now.roughness * water_now.roughness, spacing, p.slopes);
}

// Direction of the reflected light seen at the eye, after one reflection; never below the horizon.
vec3 mirrored_direction(Facet facet, vec3 to_eye) {
    vec3 mirrored = reflect(-to_eye, facet.normal);
    return vec3(mirrored.x, abs(mirrored.y), mirrored.z);
}
