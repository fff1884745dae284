// right, in its pictures too
vec4 quaternion_square(vec4 q) {
    float r = q.x * q.x - q.y * q.y - q.z * q.z - q.w * q.w;
    return vec4(r, q.x * q.y + q.y * q.x + q.z * q.w - q.w * q.z, 2.0 * q.x * q.z, 2.0 * q.x * q.w);
}
