// Lamps of finite size: discs facing the point, as in chapter 05, and tubes as strips facing it.
#include "04_surface_maps/above_horizon.glsl"
#include "04_surface_maps/microfacets.glsl"
#include "04_surface_maps/nearest_on_lamp.glsl"

#if defined(HAS_COAT) && SURFACE_GGX
#define HAS_GGX 1
#else
#define HAS_GGX 0
#endif

// Lamp shape with the irradiance of a point light on a surface facing it.
struct LampShape {
    vec3 middle;         // from the shaded point, metres; unit length for the sun
    vec3 across, along;  // half axes of a disc, half sides of a strip
    float weight;        // lamp radiance, for radiance 1 of a white Lambertian surface facing it
    bool is_tube;
};

vec3 safe_normalize(vec3 v) { return v * inversesqrt(max(dot(v, v), 1e-36)); }

LampShape shape_of(LightData light, vec3 position) {
    LampShape s;
    s.middle = light.kind == LIGHT_DIRECTIONAL ? -light.direction : light.position - position;
    s.is_tube = light.half_tube != vec3(0.0);
    vec3 axis = s.is_tube ? light.half_tube : abs(s.middle.y) < 0.9 * length(s.middle) ? vec3(0, 1, 0) : vec3(1, 0, 0);
    s.across = light.radius * safe_normalize(cross(s.middle, axis));
    s.along = s.is_tube ? light.half_tube : light.radius * safe_normalize(cross(s.across, s.middle));
    float away = dot(s.middle, s.middle), squared = light.radius * light.radius;
    float area = s.is_tube ? 4.0 * light.radius * length(light.half_tube) : pi * squared;
    s.weight = (s.is_tube ? away : away + squared) * pi / max(area, 1e-30);
    return s;
}

bool is_above(vec3 facing, uint light, vec3 position, vec3 to_light) {
    LightData data = lights_data[light];
    if (data.radius <= 0.0) return dot(facing, to_light) > 0.0;
    LampShape s = shape_of(data, position);
    return dot(facing, s.middle) + abs(dot(facing, s.across)) + abs(dot(facing, s.along)) > 0.0;
}

#if LAMPS_METHOD == LAMPS_METHOD_REPRESENTATIVE && HAS_GGX
// Light of several microfacets, of which `reflect_light().specular` is a part.
vec3 after_several(Surface surface, vec3 to_light) {
    return lit_coat.multiple * multiple_towards(lit_coat, albedos_at(surface, to_light).rg) *
           max(dot(surface.normal, to_light), 0.0);
}

// Representative point: the lamp's point nearest to the mirrored ray, with a wider lobe (B. Karis, "Real Shading in
// Unreal Engine 4", 2013).
Reflected reflect_by_nearest_point(Surface surface, LampShape s) {
    vec3 mirrored = reflect(-surface.to_eye, surface.normal), nearest = s.middle;
    if (s.is_tube) {
        vec3 end = s.middle - s.along, tube = 2.0 * s.along;
        float turned = dot(mirrored, tube), over = dot(tube, tube) - turned * turned;
        nearest = end + tube * clamp((dot(mirrored, end) * turned - dot(end, tube)) / max(over, 1e-6 * dot(tube, tube)), 0.0, 1.0);
    }
    nearest = nearest_on_lamp(nearest, length(s.across), mirrored);
    float alpha = alpha_of(surface.shininess), away = 2.0 * length(s.middle);
    float wider = alpha / min(alpha + length(s.across) / away, 1.0);
    float energy = wider * (s.is_tube ? alpha / min(alpha + length(s.along) / away, 1.0) : wider);
    vec3 to_middle = safe_normalize(s.middle), to_nearest = safe_normalize(nearest);  // none within the lamp
    vec3 single = reflect_light(surface, to_nearest).specular - after_several(surface, to_nearest);
    return Reflected(reflect_light(surface, to_middle).diffuse, energy * single + after_several(surface, to_middle));
}
#elif LAMPS_METHOD == LAMPS_METHOD_LTC && HAS_GGX
uniform sampler2D ggx_cosines;

// An edge's share of a polygon's cosine-weighted solid angle, over pi (J. H. Lambert, "Photometria", 1760). Angle over
// sine by a fit (S. Hill and E. Heitz, "Real-Time Area Lighting", SIGGRAPH course, 2016).
float edge_share(vec3 from, vec3 to) {
    float cosine = dot(from, to), x = abs(cosine);
    float acute = (0.8543985 + (0.4965155 + 0.0145206 * x) * x) / (3.4175940 + (4.1616724 + x) * x);
    float ratio = cosine > 0.0 ? acute : 0.5 * inversesqrt(max(1.0 - x * x, 1e-7)) - acute;
    return ratio * (from.x * to.y - from.y * to.x);
}

// Form factor of the lamp about z, clipped at the horizon. Discs are 12-gons of equal area.
float lamp_share(LampShape s, mat3 to_lobe) {
    mat3 to_corner = to_lobe * mat3(s.across, s.along, s.middle);
    int corners = s.is_tube ? 4 : 12;
    vec2 turn = s.is_tube ? vec2(0.0, 1.0) : vec2(0.8660254, 0.5), at = s.is_tube ? vec2(1.0) : vec2(1.02333, 0.0);
    vec3 from = normalize(to_corner * vec3(dot(at, turn), at.y * turn.x - at.x * turn.y, 1.0));
    vec3 set, risen;  // crossings of outline and horizon
    bool is_cut = false;
    float sum = 0.0;
    for (int i = 0; i < corners; ++i) {
        vec3 to = normalize(to_corner * vec3(at, 1.0));
        if (from.z > 0.0 || to.z > 0.0) {
            vec3 first = normalize(above_horizon(from, to)), last = normalize(above_horizon(to, from));
            if (from.z <= 0.0) risen = first;
            if (to.z <= 0.0) set = last;
            is_cut = is_cut || from.z <= 0.0 || to.z <= 0.0;
            sum += edge_share(first, last);
        }
        from = to;
        at = vec2(at.x * turn.x - at.y * turn.y, at.x * turn.y + at.y * turn.x);
    }
    if (is_cut) sum += edge_share(set, risen);
    return abs(sum);
}

// A and B of the split sum over the lamp: five of its points, by their cosine.
vec2 albedos_over(Surface surface, LampShape s) {
    vec3 sum = vec3(0.0, 0.0, 1e-6);
    for (int i = 0; i < 5; ++i) {
        vec3 off = i == 0 ? vec3(0.0) : ((i & 1) == 0 ? s.across : s.along) * (i < 3 ? 0.7 : -0.7);
        vec3 to_point = safe_normalize(s.middle + off);
        float cosine = max(dot(surface.normal, to_point), 1e-3);
        sum += cosine * vec3(albedos_at(surface, to_point).rg, 1.0);
    }
    return sum.xy / sum.z;
}

// [ltc]
// Linearly transformed cosines: GGX times n·l as a transformed cosine lobe (E. Heitz et al., SIGGRAPH 2016).
Reflected reflect_by_cosines(Surface surface, LampShape s) {
    vec3 n = surface.normal, flat_eye = surface.to_eye - n * dot(n, surface.to_eye);
    if (dot(flat_eye, flat_eye) < 1e-10) flat_eye = abs(n.x) < 0.6 ? vec3(0.0, n.z, -n.y) : vec3(-n.z, 0.0, n.x);
    vec3 x = normalize(flat_eye);
    mat3 to_surface = transpose(mat3(x, cross(n, x), n));
    vec4 m = textureLod(ggx_cosines, in_ggx_table(dot(n, surface.to_eye), surface.shininess), 0.0);
    mat3 to_cosine = mat3(vec3(m.x, 0.0, m.z), vec3(0.0, 1.0, 0.0), vec3(m.y, 0.0, m.w));
    float received = s.weight * lamp_share(s, to_surface);
    float mirrored = s.weight * lamp_share(s, to_cosine * to_surface);
    vec2 ab = albedos_over(surface, s);
    return Reflected(lit_coat.entering * entering_towards(lit_coat, ab) * received,
                     lit_coat.single * mirrored + lit_coat.multiple * multiple_towards(lit_coat, ab) * received);
}
// [/ltc]
#elif LAMPS_METHOD == LAMPS_METHOD_SAMPLED
layout(scalar) uniform LampsBlock { int samples; } lamps;

// Mean over points of the lamp; on a disc, Vogel's spiral (1979).
Reflected reflect_by_samples(Surface surface, LampShape s) {
    Reflected sum = Reflected(vec3(0.0), vec3(0.0));
    vec3 facing = safe_normalize(cross(s.across, s.along));
    float area = s.is_tube ? 4.0 * length(s.across) * length(s.along) : pi * dot(s.across, s.across);
    int count = lamps.samples;
    for (int i = 0; i < count; ++i) {
        float radius = sqrt((float(i) + 0.5) / float(count)), angle = 2.39996323 * float(i);
        vec2 at = s.is_tube ? 2.0 * fract(0.5 + float(i) * vec2(0.75487767, 0.56984029)) - 1.0
                            : radius * vec2(cos(angle), sin(angle));
        vec3 to_point = s.middle + at.x * s.across + at.y * s.along;
        float away = dot(to_point, to_point);
        vec3 to_light = to_point * inversesqrt(max(away, 1e-12));
        float weight = s.weight * area / (pi * float(count)) * abs(dot(facing, to_light)) / max(away, 1e-12);
        Reflected one = reflect_light(surface, to_light);
        sum.diffuse += weight * one.diffuse;
        sum.specular += weight * one.specular;
    }
    return sum;
}
#endif

Reflected reflect_lamp(Surface surface, uint light, vec3 position, vec3 to_light) {
    LightData data = lights_data[light];
    if (data.radius <= 0.0) return reflect_light(surface, to_light);
    LampShape s = shape_of(data, position);
#if LAMPS_METHOD == LAMPS_METHOD_SAMPLED
    return reflect_by_samples(surface, s);
#elif LAMPS_METHOD == LAMPS_METHOD_REPRESENTATIVE && HAS_GGX
    return reflect_by_nearest_point(surface, s);
#elif LAMPS_METHOD == LAMPS_METHOD_LTC && HAS_GGX
    return reflect_by_cosines(surface, s);
#else
    return reflect_light(surface, to_light);
#endif
}
