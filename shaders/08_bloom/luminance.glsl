// Of linear light with Rec. 709 primaries.
float luminance(vec3 radiance) { return dot(radiance, vec3(0.2126, 0.7152, 0.0722)); }
