// Barycentric weights of a visibility buffer's pixels
// (C. Burns and W. Hunt, "The Visibility Buffer: A Cache-Friendly Approach to Deferred Shading", JCGT 2(2), 2013).
uniform usampler2D visible;  // item + 1 and triangle; 0: nothing

// [shares]
// Perspective-correct barycentric weights at a point of the screen (-1 to 1, y down). Corners are in clip space and may
// lie behind the eye: with the point moved to the origin each is (x, y) w, and the area spanned by two is the weight of
// the third (M. Olano and T. Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", Graphics Hardware
// 1997).
vec3 shares(vec4 corners[3], vec2 place) {
    vec2 a = corners[0].xy - place * corners[0].w;
    vec2 b = corners[1].xy - place * corners[1].w;
    vec2 c = corners[2].xy - place * corners[2].w;
    vec3 spanned = vec3(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
    float sum = spanned.x + spanned.y + spanned.z;
    return sum != 0.0 ? spanned / sum : vec3(1.0, 0.0, 0.0);
}
// [/shares]

// Weights at a pixel's centre, and their screen-space derivatives.
struct Shares {
    vec3 here, across, down;
};

Shares shares_at(vec4 corners[3], ivec2 pixel, ivec2 size) {
    vec2 step = 2.0 / vec2(size), place = (vec2(pixel) + 0.5) * step - 1.0;
    vec3 here = shares(corners, place);
    Shares s = Shares(here, shares(corners, place + vec2(step.x, 0.0)) - here,
                      shares(corners, place + vec2(0.0, step.y)) - here);
    // Clamped: rasterisers round corners, so the centre may lie beside a narrow triangle.
    s.here = max(here, 0.0);
    s.here /= s.here.x + s.here.y + s.here.z;
    return s;
}
