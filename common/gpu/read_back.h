// Asynchronous read-back from a frame to the host.
#pragma once
#include <cstring>
#include <memory>
#include <span>

#include "common/gpu/buffer.h"

namespace lightwalk {

/// Where Frame::read_back puts bytes: they are there when that frame has ended. It may go before.
class ReadBack {
  public:
    /// False until the first frame that read back into this has ended.
    explicit operator bool() const { return state_ && state_->bytes > 0; }

    /// Of the last frame that ended; valid until the next one does.
    std::span<const std::byte> bytes() const {
        return *this ? std::span(state_->staging.mapped, state_->bytes) : std::span<const std::byte>();
    }

    /// The same as numbers or structs; a remainder is dropped.
    template <class T>
    std::vector<T> as() const {
        std::vector<T> result(bytes().size() / sizeof(T));
        if (!result.empty()) std::memcpy(result.data(), bytes().data(), result.size() * sizeof(T));
        return result;
    }

    /// Another one for each frame that has brought bytes; 0: none has.
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
