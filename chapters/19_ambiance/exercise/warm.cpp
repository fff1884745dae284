// Exercise 19.warm: what has to be on the GPU before a cut.
// Starter: only what is on the screen is there, and the first frame after each cut waits for files and shaders.
#include "19_ambiance/exercises.h"

namespace lightwalk::exercise {

// [warm]
// A film holds its scenes in the device's memory while it needs them: their models, images,
// targets and pipelines. Making a scene ready takes seconds, and there is room for `most` of
// them (1 or more). Returns the indices into `scenes` of those that have to be ready at the
// time now_s, in the order in which to make them ready:
//
// 1. first those on the screen (from_s <= now_s < to_s), the one that began earlier first.
//    There is no picture without them: all are returned, even where they are more than `most`;
// 2. then those that begin within the next ahead_s seconds (now_s < from_s <= now_s + ahead_s),
//    the next one first, as long as there are fewer than `most` in the result.
//
// Of scenes that begin at the same time, the one that stands earlier in `scenes` comes first.
// Scenes stand in `scenes` in any order. What was on the screen before is not needed again: a
// scene that is not returned may be dropped.
// [/warm]
std::vector<int> warm(const std::vector<OnScreen>& scenes, double now_s, double /*ahead_s*/, int /*most*/) {
    std::vector<int> ready;
    for (int i = 0; i < int(scenes.size()); ++i)
        if (scenes[size_t(i)].from_s <= now_s && now_s < scenes[size_t(i)].to_s) ready.push_back(i);
    return ready;
}

}  // namespace lightwalk::exercise
