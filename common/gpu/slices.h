// Uploads in slices, between frames that go on meanwhile.
#pragma once
#include <deque>

#include "common/gpu/gpu.h"

namespace lightwalk {

// [slices]
/// Uploads that wait in order. step() does as many slices of a few megabytes as a budget of time allows: each waits for the
/// device, 500 MB at once would stop the picture for as long as they take.
class Slices {
  public:
    static constexpr size_t slice_bytes = size_t{4} << 20;

    /// Makes the buffer and fills it. `to` and `bytes` stay where they are until step() has said that nothing is left.
    void add(Buffer& to, const std::string& name, std::span<const std::byte> bytes);

    /// Fills a one-layer image, as Gpu::upload() does. The data must outlive the upload, as above.
    void add(Image& to, const std::vector<std::vector<std::byte>>& levels);

    /// In its turn, as a slice of its own: gives back memory that is not needed once those before it are done.
    template <class T>
    void forget(std::vector<T>& bytes) {
        add([&bytes](Gpu&) { std::vector<T>().swap(bytes); });
    }

    /// One slice at least, more until `budget_ms` have passed. True: nothing is left.
    bool step(Gpu& gpu, double budget_ms);

    /// Fraction done, 0 to 1.
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
