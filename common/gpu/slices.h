// Incremental uploads between frames.
#pragma once
#include <deque>

#include "common/gpu/gpu.h"

namespace lightwalk {

// [slices]
/// Queue of uploads in slices that fit a time budget: 500 MB at once would freeze the window.
class Slices {
  public:
    static constexpr size_t slice_bytes = size_t{4} << 20;

    /// Creates and fills a buffer. `to` and `bytes` must stay valid until step() returns true.
    void add(Buffer& to, const std::string& name, std::span<const std::byte> bytes);

    /// Fills a one-layer image from its mip levels. `to` and `levels` must stay valid until step() returns true.
    void add(Image& to, const std::vector<std::vector<std::byte>>& levels);

    /// Frees `bytes` once all uploads queued before have finished.
    template <class T>
    void forget(std::vector<T>& bytes) {
        add([&bytes](Gpu&) { std::vector<T>().swap(bytes); });
    }

    /// Performs at least one slice, then more until `budget_ms` have passed. True: queue empty.
    bool step(Gpu& gpu, double budget_ms);

    float share() const { return count_ ? 1.0f - float(waiting_.size()) / float(count_) : 1.0f; }
    // [/slices]

  private:
    using Slice = std::function<void(Gpu& gpu)>;
    void add(Slice slice) { waiting_.push_back(std::move(slice)), ++count_; }
    const Buffer& staged(Gpu& gpu, std::span<const std::byte> bytes);
    std::deque<Slice> waiting_;
    size_t count_ = 0;
    Buffer staging_;
};

}  // namespace lightwalk
