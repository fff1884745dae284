// [minimal]
#version 460
// Two triangles that look like a rough wall: where a ray meets a height map, and the normal that is stored there.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 corner_normal;
layout(location = 2) in vec2 uv;
layout(location = 0) out vec4 color;
layout(binding = 0) uniform sampler2D albedo_map;  // sRGB
layout(binding = 1) uniform sampler2D normal_map;  // directions, packed as 0.5 + 0.5 n
layout(binding = 2) uniform sampler2D depth_map;   // 0: the triangle, 1: the bottom of the deepest groove
layout(push_constant) uniform Frame { vec4 eye, to_sun; float deepest; };  // deepest: groove depth, in texture widths

// Tangent frame without attributes: the directions on the surface in which u and v grow, from how position and texture
// coordinate change between neighbouring pixels (C. Schüler, ShaderX5, 2006). Columns: tangent, bitangent, normal.
mat3 tangent_frame(vec3 normal, vec3 step_x, vec3 step_y, vec2 uv_x, vec2 uv_y) {
    vec3 across_x = cross(normal, step_x), across_y = cross(step_y, normal);
    vec3 tangent = across_y * uv_x.x + across_x * uv_y.x, bitangent = across_y * uv_x.y + across_x * uv_y.y;
    float longest = max(dot(tangent, tangent), dot(bitangent, bitangent));
    return mat3(tangent * inversesqrt(longest), bitangent * inversesqrt(longest), normal);
}

float depth_at(vec2 place) { return textureLod(depth_map, place, 0.0).r; }

// The ray goes into the surface at `start` and moves by `shift` until it is as deep as the deepest groove. Returns how
// deep it is (0 to 1) where it meets the height map: steps until it is below, then halving (Policarpo et al., 2005).
float hit_depth(vec2 start, vec2 shift, int steps) {
    float above = 0.0, below = 1.0;
    for (int i = 1; i <= steps; ++i) {
        below = float(i) / float(steps);
        if (depth_at(start + below * shift) <= below) break;
        above = below;
    }
    for (int i = 0; i < 8; ++i) {
        float middle = 0.5 * (above + below);
        if (depth_at(start + middle * shift) <= middle) below = middle;
        else above = middle;
    }
    return below;
}

void main() {
    mat3 frame = tangent_frame(normalize(corner_normal), dFdx(position), dFdy(position), dFdx(uv), dFdy(uv));
    vec3 to_eye = transpose(frame) * normalize(eye.xyz - position);  // in the frame: z is height over the triangle
    vec2 shift = -to_eye.xy / max(to_eye.z, 0.1) * deepest;
    vec2 place = uv + hit_depth(uv, shift, int(mix(64.0, 16.0, abs(to_eye.z)))) * shift;  // more steps at a slant
    // The jump at a groove's edge is not the texture's own scale: levels come from the derivatives of `uv`.
    vec3 normal = frame * (2.0 * textureGrad(normal_map, place, dFdx(uv), dFdy(uv)).xyz - 1.0);
    vec3 albedo = textureGrad(albedo_map, place, dFdx(uv), dFdy(uv)).rgb;
    color = vec4(albedo * (max(dot(normalize(normal), to_sun.xyz), 0.0) + 0.1), 1.0);
}
// [/minimal]
