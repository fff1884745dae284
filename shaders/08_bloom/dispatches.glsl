// Workgroups of each step of the blur, three words each; then the last frame that found anything bright, and whether the
// blur spreads anything.
#ifndef DISPATCH_ACCESS
#define DISPATCH_ACCESS coherent
#endif
layout(scalar) DISPATCH_ACCESS buffer DispatchBuffer { uint dispatches[]; };
uint lit_at() { return uint(dispatches.length()) - 3u; }
uint spreads_at() { return lit_at() + 1u; }
