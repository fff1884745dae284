// [minimal]
#version 460
// A shadow map in one shader: a ball over a floor. Texels of the map are computed where they are read.
layout(location = 0) in vec3 ray;  // of the pixel; metres, y points up
layout(location = 0) out vec4 color;
layout(push_constant) uniform Frame { vec4 eye; };
const float side = 256.0, half_width_m = 2.5, offset_texels = 2.83;  // texels along an edge, half the width, bias
const vec3 center = vec3(0.0, 1.0, 0.0), to_sun = vec3(0.43193421, 0.86386843, 0.25916053);
const vec3 right = vec3(0.51449576, 0.0, -0.85749293);

// The first surface along a ray, in metres; 1e9 where there is none.
float hit(vec3 origin, vec3 direction) {
    float floor_m = direction.y < 0.0 ? -origin.y / direction.y : 1e9;
    float near = dot(center - origin, direction);
    vec3 beside = origin + near * direction - center;  // large squares would cancel and lose their digits
    float rest = 0.36 - dot(beside, beside);
    float ball_m = rest >= 0.0 && near - sqrt(rest) > 1e-6 ? near - sqrt(rest) : 1e9;
    return min(floor_m, ball_m);
}

// The depth that the map stores in a texel: seen from the sun, through the texel's middle.
float stored(vec2 texel) {
    vec2 at = (texel + 0.5) * 2.0 * half_width_m / side - half_width_m;
    return hit(at.x * right + at.y * cross(to_sun, right) + 10.0 * to_sun, -to_sun) - 10.0;
}

// 1 in the light, 0 in the shadow: 3x3 comparisons (PCF), from a point lifted off its surface.
float lit(vec3 point, vec3 normal, float offset_m) {
    vec3 at = point + offset_m * normal;
    vec2 across = vec2(dot(at, right), dot(at, cross(to_sun, right)));
    vec2 texel = floor((across + half_width_m) * side / (2.0 * half_width_m));
    float sum = 0.0;
    for (int k = 0; k < 9; ++k) sum += float(-dot(at, to_sun) <= stored(texel + vec2(k % 3 - 1, k / 3 - 1)));
    return sum / 9.0;
}

void main() {
    vec3 direction = normalize(ray);
    float t = hit(eye.xyz, direction);
    color = vec4(0.25, 0.32, 0.42, 1.0);
    vec3 point = eye.xyz + t * direction, normal = point.y < 1e-3 ? vec3(0.0, 1.0, 0.0) : normalize(point - center);
    if (t > 30.0) return;
    float facing = max(dot(normal, to_sun), 0.0);
    float light = facing > 0.0 ? lit(point, normal, offset_texels * 2.0 * half_width_m / side) : 0.0;
    color.rgb = (point.y < 1e-3 ? vec3(0.45, 0.43, 0.40) : vec3(0.7, 0.2, 0.12)) * (facing * light + 0.15);
}
// [/minimal]
