// Of 8 by 8 texels of the half picture how far the widest disc in front of the focus reaches, in pixels, and whether
// anything is out of focus.
layout(local_size_x = 8, local_size_y = 8) in;
uniform sampler2D half_picture;
layout(rg16f) writeonly uniform image2D tiles;
shared float nearest[64], widest[64];

void main() {
    ivec2 texel = min(ivec2(gl_GlobalInvocationID.xy), textureSize(half_picture, 0) - 1);
    uint own = gl_LocalInvocationIndex;
    float disc_px = texelFetch(half_picture, texel, 0).a;
    nearest[own] = max(-disc_px, 0.0);
    widest[own] = abs(disc_px);
    for (uint other = 32u; other > 0u; other /= 2u) {
        barrier();
        if (own < other) {
            nearest[own] = max(nearest[own], nearest[own + other]);
            widest[own] = max(widest[own], widest[own + other]);
        }
    }
    if (own == 0u) imageStore(tiles, ivec2(gl_WorkGroupID.xy), vec4(nearest[0], widest[0], 0.0, 0.0));
}
