// Density and looks by weights that are floats. Filters of hardware may have no more than 8 bits for a weight
// (subTexelPrecisionBits), whose steps a thin layer shows.
#if VOLUME_METHOD == VOLUME_METHOD_EXACT
float exact_density_at(vec3 position) {
    ivec3 last = textureSize(volume_field, 0) - 1;
    vec3 at = waved(to_texture(position)) * vec3(last + 1) - 0.5, low = floor(at), share = at - low;
    ivec3 a = clamp(ivec3(low), ivec3(0), last), b = clamp(ivec3(low) + 1, ivec3(0), last);
    vec4 near = vec4(texelFetch(volume_field, ivec3(a.x, a.y, a.z), 0).r, texelFetch(volume_field, ivec3(a.x, b.y, a.z), 0).r,
                     texelFetch(volume_field, ivec3(a.x, a.y, b.z), 0).r, texelFetch(volume_field, ivec3(a.x, b.y, b.z), 0).r);
    vec4 far = vec4(texelFetch(volume_field, ivec3(b.x, a.y, a.z), 0).r, texelFetch(volume_field, ivec3(b.x, b.y, a.z), 0).r,
                    texelFetch(volume_field, ivec3(b.x, a.y, b.z), 0).r, texelFetch(volume_field, ivec3(b.x, b.y, b.z), 0).r);
    vec4 along_x = mix(near, far, share.x);
    vec2 along_y = mix(along_x.xz, along_x.yw, share.y);
    return density_of(mix(along_y.x, along_y.y, share.z));
}

vec4 exactly_classified(float density) {
    float entry = density * float(TRANSFER_TEXELS - 1);
    int low = min(int(entry), TRANSFER_TEXELS - 2);
    return mix(texelFetch(volume_transfer, ivec2(low, 0), 0), texelFetch(volume_transfer, ivec2(low + 1, 0), 0), entry - float(low));
}
#endif
