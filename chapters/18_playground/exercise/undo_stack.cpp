// Exercise 18.undo_stack: the list of steps that can be undone.
// Starter: each frame of a drag is a step, and memory has no bound.
#include "18_playground/exercises.h"

namespace lightwalk::exercise {

// [undo_stack]
// Decides about a new step. `done` are the steps that can be undone, the oldest first. `step`
// was just made. `has_undone`: some steps were undone just before and could be redone; the new
// step discards them.
//
// A drag of 100 frames is 100 steps to the program and one to a person. A step therefore joins
// the last one of `done` if both have the same group and the group is not 0. After an undo
// (`has_undone`) it joins nothing. A step that joins adds its bytes to those of the last one.
// Then the oldest steps are forgotten: as few as possible, so that the steps that are left, the
// new one included, have at most `most_bytes` together. The new step (joined or not) is never
// forgotten, even if it alone is larger than that. A person can thus always undo the last thing
// that was done.
Pushed push_step(std::span<const UndoSize> done, const UndoSize& step, bool has_undone, uint64_t most_bytes) {
    (void)done, (void)step, (void)has_undone, (void)most_bytes;
    return {};
}

// Returns two steps as one. `first` and `then` have each entry at most once. The result has the
// entries of `first` in their order, followed by those entries of `then` that are not in
// `first`, in theirs. If an entry is in both, its `before` is that of `first` and its `after`
// that of `then`. An entry whose `before` and `after` are then equal was not changed, and is
// left out. Examples are a new object that was deleted again (0 and 0), and an object that was
// dragged back to where it was. Steps have up to 100,000 entries: do not search the whole other
// list for each of them.
std::vector<Replaced> join_steps(std::span<const Replaced> first, std::span<const Replaced> then) {
    std::vector<Replaced> both(first.begin(), first.end());
    both.insert(both.end(), then.begin(), then.end());
    return both;
}
// [/undo_stack]

}  // namespace lightwalk::exercise
