// Solution of 05.corner_weights: with the place moved to the origin each corner is (x, y) w, and the area spanned by two is the
// weight of the third (M. Olano and T. Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", Graphics Hardware
// 1997).
vec3 corner_weights(vec4 a, vec4 b, vec4 c, vec2 place) {
    vec2 p = a.xy - place * a.w;
    vec2 q = b.xy - place * b.w;
    vec2 r = c.xy - place * c.w;
    vec3 spanned = vec3(q.x * r.y - q.y * r.x, r.x * p.y - r.y * p.x, p.x * q.y - p.y * q.x);
    float sum = spanned.x + spanned.y + spanned.z;
    return sum != 0.0 ? spanned / sum : vec3(1.0, 0.0, 0.0);
}
