// For the check: pcf() over a map that is known, and how many texels it took.
#include "05_shadow_maps/pcf.glsl"

vec3 pcf_counted(vec2 uv, float depth, vec2 slope, int kernel) {
    float visible = pcf(Receiver(vec3(uv, depth), slope), 0u, kernel);
    return vec3(visible, texels_gathered, texels_read);
}
