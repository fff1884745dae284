#include <unordered_map>

#include "18_playground/exercises.h"

namespace lightwalk::solution {

Pushed push_step(std::span<const UndoSize> done, const UndoSize& step, bool has_undone, uint64_t most_bytes) {
    Pushed pushed;
    pushed.joins = !has_undone && step.group != 0 && !done.empty() && done.back().group == step.group;
    uint64_t bytes = step.bytes;
    for (const UndoSize& one : done) bytes += one.bytes;
    const size_t others = done.size() - (pushed.joins ? 1 : 0);
    while (bytes > most_bytes && pushed.forgotten < others) bytes -= done[pushed.forgotten++].bytes;
    return pushed;
}

std::vector<Replaced> join_steps(std::span<const Replaced> first, std::span<const Replaced> then) {
    std::vector<Replaced> both(first.begin(), first.end());
    std::unordered_map<uint32_t, size_t> places;
    for (size_t i = 0; i < first.size(); ++i) places.emplace(first[i].entry, i);
    for (const Replaced& one : then) {
        const auto place = places.find(one.entry);
        if (place == places.end())
            both.push_back(one);
        else
            both[place->second].after = one.after;
    }
    std::erase_if(both, [](const Replaced& one) { return one.before == one.after; });
    return both;
}

}  // namespace lightwalk::solution
