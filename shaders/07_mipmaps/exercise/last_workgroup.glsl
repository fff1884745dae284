// Exercise 07.last_workgroup: the workgroup of a dispatch that finishes last.
// Starter: no workgroup is the last: a single pass ends with the sixth level.

// [last_workgroup]
// Every workgroup calls this function once, with all of its threads together, after its
// first thread (gl_LocalInvocationIndex 0) has written the workgroup's result to a
// coherent buffer. finished[layer] is 0 before the dispatch. `workgroups` is the number
// of workgroups that call it for this layer.
//
// Returns true, in all threads alike, for the one workgroup that calls last, and false
// in all others. In the last workgroup, reads of the coherent buffer after the call
// must return what all other workgroups have written.
//
// Three things to consider:
// - Each workgroup counts once. atomicAdd returns the value before the addition.
// - That value is known to one thread, and the others need it: use a shared variable.
// - Other workgroups see two writes in no particular order unless memoryBarrierBuffer()
//   separates them. You need such an order before you count and after it.
// [/last_workgroup]
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

bool is_last_workgroup(int layer, uint workgroups) {
    return false;
}
