// What a half float holds of light: below 0 and NaN is 0, above 65504 and infinity is 65504.
vec3 finite_light(vec3 radiance) { return mix(clamp(radiance, 0.0, 65504.0), vec3(0.0), isnan(radiance)); }
