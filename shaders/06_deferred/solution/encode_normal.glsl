// Solution of 06.encode_normal (Q. Meyer et al., "On Floating-Point Normal Vectors", EGSR 2010; Z. Cigolle et al., "A
// Survey of Efficient Representations for Independent Unit Vectors", JCGT 3(2), 2014, listing 1).

vec2 encode_normal(vec3 normal) {
    vec2 e = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    if (normal.z >= 0.0) return e;
    // Not sign(), which is 0 for 0: the axes and the pole -z would end up in the middle.
    return (1.0 - abs(e.yx)) * vec2(e.x < 0.0 ? -1.0 : 1.0, e.y < 0.0 ? -1.0 : 1.0);
}
