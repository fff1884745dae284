// Exercise 07.last_workgroup: of all workgroups of a dispatch, which is the one that finishes last?
// Until you fill it in, none is: a single pass ends with the sixth level.

// [last_workgroup]
// finished[layer] is 0 before the dispatch. Every workgroup calls this once, all of its threads together, after its
// first thread has written the workgroup's result to a coherent buffer. Returns true, in all threads alike, for the one
// workgroup that calls last of `workgroups`; what it reads of the buffer from then on is what all others have written.
// Three things to think of: each workgroup counts once, and the number that was there before tells who was last; one
// thread's number has to reach the others, through shared memory; and a write is not seen by others in any order unless
// you ask for one, before you count and after.
// [/last_workgroup]
layout(scalar) coherent buffer FinishedBuffer { uint finished[]; };

bool is_last_workgroup(int layer, uint workgroups) {
    return false;
}
