// Asynchronous read-back from device to host.
#pragma once
#include <cstring>
#include <memory>
#include <span>

#include "common/gpu/buffer.h"

namespace lightwalk {

/// Destination of Frame::read_back(), filled when that frame ends. May be destroyed earlier.
class ReadBack {
  public:
    /// False until a frame with a read-back into this object has ended.
    explicit operator bool() const { return state_ && state_->bytes > 0; }

    /// Contents from the last ended frame, valid until the next one ends.
    std::span<const std::byte> bytes() const {
        return *this ? std::span(state_->staging.mapped, state_->bytes) : std::span<const std::byte>();
    }

    template <class T>
    std::vector<T> as() const {
        std::vector<T> result(bytes().size() / sizeof(T));
        if (!result.empty()) std::memcpy(result.data(), bytes().data(), result.size() * sizeof(T));
        return result;
    }

    /// Number that changes with each new contents; 0: none yet.
    uint64_t number() const { return state_ ? state_->number : 0; }

  private:
    friend class Recording;
    friend class Frame;
    struct State {
        Buffer staging, spare;
        size_t bytes = 0;
        uint64_t number = 0;
    };
    std::shared_ptr<State> state_;
};

}  // namespace lightwalk
