// A visibility buffer: which triangle a pixel shows. Where in the triangle its middle lies follows from the corners.
// (C. Burns and W. Hunt, The visibility buffer: a cache-friendly approach to deferred shading, JCGT 2(2), 2013.)
uniform usampler2D visible;  // item + 1 and triangle; 0: nothing

// [shares]
// Barycentric weights of each corner at a point of the screen (-1 to 1, y down), as a rasteriser would interpolate.
// Corners in clip space, also behind the eye: moved so that the point is the middle, each is (x, y) w, and the area
// spanned by two is the weight of the third. (M. Olano and T. Greer, Triangle scan conversion using 2D homogeneous
// coordinates, Graphics Hardware 1997.)
vec3 shares(vec4 corners[3], vec2 place) {
    vec2 a = corners[0].xy - place * corners[0].w;
    vec2 b = corners[1].xy - place * corners[1].w;
    vec2 c = corners[2].xy - place * corners[2].w;
    vec3 spanned = vec3(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
    float sum = spanned.x + spanned.y + spanned.z;
    return sum != 0.0 ? spanned / sum : vec3(1.0, 0.0, 0.0);
}
// [/shares]

// At the middle of a pixel, and how much they change to the next one across and down.
struct Shares {
    vec3 here, across, down;
};

Shares shares_at(vec4 corners[3], ivec2 pixel, ivec2 size) {
    vec2 step = 2.0 / vec2(size), place = (vec2(pixel) + 0.5) * step - 1.0;
    vec3 here = shares(corners, place);
    Shares s = Shares(here, shares(corners, place + vec2(step.x, 0.0)) - here,
                      shares(corners, place + vec2(0.0, step.y)) - here);
    // A rasteriser rounds corners: the middle may lie beside a narrow triangle.
    s.here = max(here, 0.0);
    s.here /= s.here.x + s.here.y + s.here.z;
    return s;
}
