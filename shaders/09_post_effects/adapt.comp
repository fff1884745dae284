// From the histogram to the exposure, which follows in its own time.
#include "09_post_effects/adapt_now.h"
#include "09_post_effects/histogram_buffer.glsl"

layout(local_size_x = 256) in;

layout(scalar) uniform AutoExposureBlock { float key, darkest, brightest, least_stops, most_stops; } auto_exposure;
layout(scalar) uniform AdaptNowBlock { AdaptNow adapt_now; };
uniform sampler2D before;
layout(rgba32f) writeonly uniform image2D now;
shared float up_to[256];  // pixels in this bin and all darker ones
shared float stops_of[256];

void main() {
    uint i = gl_LocalInvocationIndex;
    float own = i == 0u ? 0.0 : float(picture_bins[i]);  // black pixels carry no information
    up_to[i] = own;
    barrier();
    for (uint reach = 1u; reach < 256u; reach *= 2u) {  // W. D. Hillis and G. L. Steele, 1986
        float more = i >= reach ? up_to[i - reach] : 0.0;
        barrier();
        up_to[i] += more;
        barrier();
    }
    // Of each bin the pixels that are neither among the darkest nor among the brightest.
    float all = up_to[255], from = auto_exposure.darkest * all, to = max((1.0 - auto_exposure.brightest) * all, from);
    float counted = clamp(up_to[i], from, to) - clamp(up_to[i] - own, from, to);
    stops_of[i] = counted * ((float(i) - 0.5) * (24.0 / 255.0) - 12.0);
    barrier();
    for (uint half_way = 128u; half_way > 0u; half_way /= 2u) {
        if (i < half_way) stops_of[i] += stops_of[i + half_way];
        barrier();
    }
    if (i > 0u) return;
    float last = adapt_now.valid != 0u ? texelFetch(before, ivec2(0), 0).r : 0.0;
    float wanted = to > from ? log2(auto_exposure.key) - stops_of[0] / (to - from) : last;
    wanted = clamp(wanted, auto_exposure.least_stops, auto_exposure.most_stops);
    imageStore(now, ivec2(0), vec4(mix(last, wanted, adapt_now.share), wanted, all, 1.0));
}
