// A square of pixels around each star.
#include "17_planets/star_data.h"

struct Star {
    vec3 direction;
    float light;
};
layout(scalar) readonly buffer StarsBuffer { Star stars[]; };
layout(scalar) uniform NowBlock { StarsNow now; };
layout(location = 0) out vec2 away_px;
layout(location = 1) flat out vec2 star;  // radiance in the middle, standard deviation in pixels

const float least_sigma_px = 0.6;  // below, the sum over the pixels depends on where the star lies between them

void main() {
    Star one = stars[gl_InstanceIndex];
    vec3 direction = now.to_view * one.direction, right = now.rays.right, down = now.rays.down;
    vec3 forward = normalize(cross(down, right));
    forward *= sign(dot(forward, now.rays.corner));
    float along = dot(direction, forward), sigma = max(now.sigma_px, least_sigma_px);
    // [energy]
    // Where the image is widened to `sigma`, its peak is lower: the light of the whole image stays that of sigma_px.
    float peak = now.brightness * one.light * (now.sigma_px * now.sigma_px) / (sigma * sigma);
    // [/energy]
    star = vec2(peak, sigma);
    gl_Position = vec4(0.0, 0.0, 0.0, -1.0);
    away_px = vec2(0.0);
    if (along < 1e-3 || peak < 1e-4) return;
    vec3 at = direction / along - now.rays.corner;
    vec2 place = vec2(dot(at, right), dot(at, down)) / dot(right, right);
    float reach = sigma * sqrt(2.0 * log(max(peak / 5e-5, 2.0))) + 1.0;
    vec2 corner = vec2(gl_VertexIndex == 1 || gl_VertexIndex == 2 || gl_VertexIndex == 4 ? 1.0 : -1.0,
                       gl_VertexIndex == 2 || gl_VertexIndex == 4 || gl_VertexIndex == 5 ? 1.0 : -1.0);
    if (any(lessThan(place, vec2(-reach))) || any(greaterThan(place, now.size + reach))) return;
    away_px = reach * corner;
    gl_Position = vec4(2.0 * (place + away_px) / now.size - 1.0, 0.5, 1.0);
}
