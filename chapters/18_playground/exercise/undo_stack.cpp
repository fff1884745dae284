// Exercise 18.undo_stack: the list of steps that can be undone.
// As it stands each frame of a drag is a step, and memory has no bound.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [undo_stack]
// `done` are the steps that can be undone, the oldest first. `step` was just made. `has_undone`: some steps were undone and
// could be done again; a new step ends that, so that the step before it is not the last thing that happened.
//
// A drag of 100 frames is 100 steps to the program and one to a person: a step joins the last one if both have the same
// group and that is not 0. It joins nothing where steps were undone in between. A step that joins adds its bytes to those
// of the last one. Then the oldest steps are forgotten, as many as it takes and no more, until the steps that are left,
// the new one included, have at most `most_bytes` together. The new step (joined or not) is never forgotten, even if it is
// larger than that: a person can undo at least the last thing that was done.
Pushed push_step(std::span<const UndoSize> done, const UndoSize& step, bool has_undone, uint64_t most_bytes) {
    (void)done, (void)step, (void)has_undone, (void)most_bytes;
    return {};
}

// Two steps as one. `first` and `then` have each entry at most once. Entries of `first` keep their order and come first, then those of
// `then` that are not in `first`, in theirs. Of an entry that is in both, what `first` found stands before and what
// `then` left stands after. What is the same before and after was not changed and is left out: a new object that was
// deleted again (0 and 0), and an object that was dragged back to where it was. Steps have up to 100,000 entries: do not
// look for each of them in the whole other list.
std::vector<Replaced> join_steps(std::span<const Replaced> first, std::span<const Replaced> then) {
    std::vector<Replaced> both(first.begin(), first.end());
    both.insert(both.end(), then.begin(), then.end());
    return both;
}
// [/undo_stack]

}  // namespace lightwalk::exercise
