// Solution of 17.flow_blend.
vec4 flow_places(vec2 uv, vec2 shift, float t) { return vec4(uv - shift * t, uv + shift * (1.0 - t)); }

float flow_weight(float t) { return t; }
