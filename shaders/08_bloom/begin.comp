// Before the picture is looked at, nothing is bright.
#include "08_bloom/dispatches.glsl"
layout(local_size_x = 1) in;
void main() { dispatches[lit_at()] = 0u; }
