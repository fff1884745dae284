// Part of 00_descriptors.cpp: ranges of a heap, allocated first fit, freed and merged with their neighbours.
#pragma once
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>

// [ranges]
class Ranges {
  public:
    explicit Ranges(uint32_t entries, bool merge = true) : merge_(merge) { free_[0] = entries; }

    /// First of `count` > 0 consecutive entries; empty if no free range is long enough.
    std::optional<uint32_t> allocate(uint32_t count) {
        for (auto range = free_.begin(); range != free_.end(); ++range) {
            const auto [first, length] = *range;
            if (length < count) continue;
            free_.erase(range);
            if (length > count) free_[first + count] = length - count;
            return first;
        }
        return std::nullopt;
    }

    void free(uint32_t first, uint32_t count) {
        auto next = free_.lower_bound(first);
        if (merge_ && next != free_.end() && first + count == next->first) {
            count += next->second;
            next = free_.erase(next);
        }
        if (merge_ && next != free_.begin())
            if (const auto before = std::prev(next); before->first + before->second == first) {
                before->second += count;
                return;
            }
        free_.emplace_hint(next, first, count);
    }

    const std::map<uint32_t, uint32_t>& free_ranges() const { return free_; }

  private:
    std::map<uint32_t, uint32_t> free_;  // length of each free range, by its first entry
    bool merge_;
};
// [/ranges]
