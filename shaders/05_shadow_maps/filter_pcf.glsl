// Shadow filters of fixed size: single comparison, or percentage-closer filtering.
#include "05_shadow_maps/compare_depth.glsl"
#include "05_shadow_maps/pcf.glsl"

// pcf() with one read per texel.
float pcf_single(Receiver r, uint layer, int kernel) {
    float size = float(map_texels()), width = float(kernel);
    vec2 corner = r.place.xy * size - 0.5 * width, first = floor(corner), part = fract(corner);
    float sum = 0.0;
    for (int y = 0; y <= kernel; ++y) {
        float row = y == 0 ? 1.0 - part.y : y == kernel ? part.y : 1.0;
        for (int x = 0; x <= kernel; ++x) {
            float column = x == 0 ? 1.0 - part.x : x == kernel ? part.x : 1.0;
            vec2 middle = (first + vec2(x, y) + 0.5) / size;
            sum += row * column * float(plane_depth(r, middle) >= read_depth(middle, layer));
        }
    }
    return sum / (width * width);
}

float hard(Receiver r, uint layer) {
    // A texel's depth is exact at its centre, so the surface's depth is compared there.
    vec2 middle = (floor(r.place.xy * float(map_texels())) + 0.5) / float(map_texels());
    vec3 place = vec3(r.place.xy, plane_depth(r, middle));
    return compare_depth(place, read_depth(r.place.xy, layer));
}

// Half-width of the filter in texels along u and v, which the bias must cover.
float filter_reach(ShadowLight light, ShadowView view, vec3 position) {
#if SHADOW_METHOD == SHADOW_METHOD_PCF
    return 0.5 * float(shadow.kernel) + 0.5;
#else
    return 0.5;
#endif
}

float filtered(ShadowLight light, ShadowView view, Receiver r, float texel, float pixel) {
#if SHADOW_METHOD == SHADOW_METHOD_HARD
    return hard(r, view.layer);
#elif SHADOW_FETCH == SHADOW_FETCH_SINGLE
    return pcf_single(r, view.layer, shadow.kernel | 1);
#else
    return pcf(r, view.layer, shadow.kernel | 1);
#endif
}
