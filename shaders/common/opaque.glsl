// Numbers of uniform blocks as a compiler sees those of which it knows nothing.
//
// Mesa 22.3's lavapipe looks for conditions that uniforms alone decide. Where it comes upon a uniform of any but a pass's
// first block on its way through a condition, it writes behind the end of a table of its own and crashes, later and elsewhere
// (lvp_inline_uniforms.c). Whether it does depends on which side of `<` a number stands, in `t <= end && d <= e` say.
// It goes no farther than a choice whose condition it cannot follow: this one.

bool is_drawn();  // true, in a way that no compiler sees through; each stage has its own

int opaque(int x) { return is_drawn() ? x : 0; }
float opaque(float x) { return is_drawn() ? x : 0.0; }
vec2 opaque(vec2 x) { return is_drawn() ? x : vec2(0.0); }
vec3 opaque(vec3 x) { return is_drawn() ? x : vec3(0.0); }
vec4 opaque(vec4 x) { return is_drawn() ? x : vec4(0.0); }
