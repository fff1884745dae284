// Workgroups of each step of the blur, three words each; the last three words begin with whether anything is to be spread.
#ifndef DISPATCH_ACCESS
#define DISPATCH_ACCESS coherent
#endif
layout(scalar) DISPATCH_ACCESS buffer DispatchBuffer { uint dispatches[]; };
uint lit_at() { return uint(dispatches.length()) - 3u; }
