// [minimal]
#version 460
// Many point and spot lights on a matt surface: distance, cone, and lights that are skipped. One run for each pixel.
struct Light {
    vec3 position;   // metres
    float range_m;   // no light farther than this
    vec3 direction;  // of a spot light's axis, unit length
    float cos_inner; // full light within this angle from the axis; -2 for a point light
    vec3 intensity;  // W/sr
    float cos_outer; // no light beyond this angle; -3 for a point light
};
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 corner_normal;
layout(location = 0) out vec4 color;
layout(std430, binding = 0) readonly buffer Lights { Light lights[]; };
layout(push_constant) uniform Material { vec4 albedo; };

// Light spreads over spheres of growing area: 1 / d². Two changes keep this usable. One square metre more stands for
// the size of the lamp, so that the light has a limit; and a window brings light and its slope to 0 at the range, so
// that the end of the light leaves no edge. Per square metre.
float distance_falloff(float distance_m, float range_m) {
    float square = distance_m * distance_m, share = square / (range_m * range_m);
    float inside = max(1.0 - share * share, 0.0);
    return inside * inside / (square + 1.0);
}

// 1 in the inner cone, 0 outside the outer one, linear between them. `cosine` is that of the angle to the axis.
float cone_falloff(float cosine, float cos_inner, float cos_outer) {
    return clamp((cosine - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
}

// The irradiance (W/m²) of one light at a point of a surface.
vec3 irradiance(Light light, vec3 point, vec3 normal) {
    vec3 offset = light.position - point;
    float square = dot(offset, offset);
    // Nearly all lights of a large scene end here. Clusters of pixels (the chapter) do not even look at them.
    if (square >= light.range_m * light.range_m) return vec3(0.0);
    vec3 to_light = offset * inversesqrt(max(square, 1e-12));
    float facing = max(dot(normal, to_light), 0.0);
    float cone = cone_falloff(dot(-to_light, light.direction), light.cos_inner, light.cos_outer);
    return light.intensity * facing * cone * distance_falloff(sqrt(square), light.range_m);
}

void main() {
    vec3 normal = normalize(corner_normal), sum = vec3(0.0);
    for (int i = 0; i < lights.length(); ++i) sum += irradiance(lights[i], position, normal);
    color = vec4(albedo.rgb / 3.14159265 * sum, 1.0);
}
// [/minimal]
