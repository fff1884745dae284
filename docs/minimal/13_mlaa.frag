// [minimal]
#version 460
// Morphological antialiasing in one shader (A. Reshetov, HPG 2009): each pixel finds the lines along its four sides and
// is mixed as a straight silhouette would mix it. Stairs left of the divider, smoothed right of it.
layout(location = 0) in vec2 uv;  // 0 to 1 over the picture
layout(location = 0) out vec4 color;  // linear light
layout(push_constant) uniform Frame { float divider, degrees, disc; };
const int side = 96;  // pixels
vec2 normal = vec2(0.0, 1.0);  // of the half plane's edge
float radius = 0.0;  // of a disc that is cut out of it; pixels

float inside(vec2 at) {
    bool plane = dot(normal, at - 48.0) < 0.3;
    return float(distance(at, vec2(42.0, 36.0)) < radius ? !plane : plane);
}

// The picture with stairs; `columns` turns it on its side.
float pixel(ivec2 at, bool columns) { return inside((columns ? vec2(at.yx) : vec2(at)) + 0.5); }

bool below(ivec2 at, bool columns) { return abs(pixel(at, columns) - pixel(at + ivec2(0, 1), columns)) > 0.1; }

bool beside(ivec2 at, bool columns) {
    return at.x > 0 && at.x < side && abs(pixel(at - ivec2(1, 0), columns) - pixel(at, columns)) > 0.1;
}

// 1. A line ends where two shapes touch at a corner.
bool corner(ivec2 at, bool columns) { return beside(at, columns) && beside(at + ivec2(0, 1), columns); }

// The edge turns between x - 1 and x: into the row below (1), into the row above (-1), or not at all.
float turn(ivec2 at, bool columns) { return float(beside(at + ivec2(0, 1), columns)) - float(beside(at, columns)); }

// 2. How far the silhouette lies under the line that passes below a pixel, in pixels; 0 where there is no line.
float under(ivec2 at, bool columns) {
    if (at.y < 0 || at.y + 1 >= side || !below(at, columns)) return 0.0;
    ivec2 first = at, end = at + ivec2(1, 0), one = ivec2(1, 0);
    while (first.x > 0 && below(first - one, columns) && !corner(first, columns)) first.x -= 1;
    while (end.x < side && below(end, columns) && !corner(end, columns)) end.x += 1;
    float t = 2.0 * (float(at.x - first.x) + 0.5) / float(end.x - first.x) - 1.0;  // -1 to 1 along the line
    return 0.5 * abs(t) * (t < 0.0 ? turn(first, columns) : turn(end, columns));
}

// 3. A pixel that the silhouette crosses takes that share of its neighbour across the line.
float smoothed(ivec2 at) {
    float sum = pixel(at, false);
    for (int k = 0; k < 2; ++k) {
        bool columns = k == 1;
        ivec2 here = columns ? at.yx : at, above = here - ivec2(0, 1);
        sum += min(under(here, columns), 0.0) * (pixel(here, columns) - pixel(here + ivec2(0, 1), columns));
        sum += max(under(above, columns), 0.0) * (pixel(above, columns) - pixel(here, columns));
    }
    return sum;
}

void main() {
    normal = vec2(sin(radians(degrees)), cos(radians(degrees))), radius = disc;
    ivec2 at = ivec2(vec2(8.0, 24.0) + uv * vec2(80.0, 45.0));
    float grey = uv.x > divider ? smoothed(at) : pixel(at, false);
    color = vec4(mix(vec3(0.03, 0.05, 0.09), vec3(0.9, 0.62, 0.3), grey), 1.0);
}
// [/minimal]
