// A picture of all directions (equirectangular: its middle is -z, its right quarter +x, its upper edge +y) and the faces
// of a cube.

// Where a direction lies in the picture, 0 to 1. At the poles every u is right: 1/2.
vec2 environment_uv(vec3 direction) {
    const float pi = 3.14159265358979;
    float u = direction.x == 0.0 && direction.z == 0.0 ? 0.5 : 0.5 + atan(direction.x, -direction.z) / (2.0 * pi);
    return vec2(u, acos(clamp(normalize(direction).y, -1.0, 1.0)) / pi);
}

// Direction through the centre of a cube face's texel; faces +x, -x, +y, -y, +z, -z, rows from the top (Vulkan 1.3,
// 16.5.4). Unit length.
vec3 cube_direction(uvec3 texel, float size) {
    vec2 st = (2.0 * vec2(texel.xy) + 1.0) / size - 1.0;
    vec3 direction = texel.z == 0u   ? vec3(1.0, -st.y, -st.x)
                     : texel.z == 1u ? vec3(-1.0, -st.y, st.x)
                     : texel.z == 2u ? vec3(st.x, 1.0, st.y)
                     : texel.z == 3u ? vec3(st.x, -1.0, -st.y)
                     : texel.z == 4u ? vec3(st.x, -st.y, 1.0)
                                     : vec3(-st.x, -st.y, -1.0);
    return normalize(direction);
}
