// The epoch: when anything was changed from outside, and when anything was derived from it.
#pragma once
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace lightwalk {

// [epoch]
/// One number that rises with every change from outside: a knob, a switch of an exercise, an edited shader, a file, an object
/// of the scene. What can change keeps the epoch of its last change (Module::epoch, Scene::epoch, Exercises::epoch).
class Epoch {
  public:
    static uint64_t next() { return ++last(); }

  private:
    static std::atomic<uint64_t>& last() {
        static std::atomic<uint64_t> epoch{0};
        return epoch;
    }
};

/// A hash of values: numbers, vectors of glm, pointers, text, structures without padding, and lists, pairs and optionals of
/// them.
template <class... Values>
uint64_t hash_of(const Values&... values);

/// Remembers from what a derived table, buffer or picture was made:
///
///     if (made_.is_current(epoch(), scene.epoch)) return;
///     // ... makes it again
///
/// Give it the epochs of what it reads, and values that change from frame to frame: the time, a camera, a size.
class Made {
  public:
    /// False if an input differs from the last call's, or nothing was made yet: make it now.
    template <class... Inputs>
    [[nodiscard]] bool is_current(const Inputs&... inputs) {
        const uint64_t now = hash_of(inputs...);
        return std::exchange(from_, now) == now;
    }
    /// After a failure: the next is_current() is false.
    void forget() { from_.reset(); }
    explicit operator bool() const { return from_.has_value(); }

  private:
    std::optional<uint64_t> from_;
};
// [/epoch]

class Hash {
  public:
    uint64_t value = 1;
    void add_bytes(const void* data, size_t bytes) {
        add_word(bytes);
        const std::string_view all(static_cast<const char*>(data), bytes);
        for (size_t at = 0; at < bytes; at += 8) {
            uint64_t word = 0;
            all.substr(at, 8).copy(reinterpret_cast<char*>(&word), 8);
            add_word(word);
        }
    }
    template <class T>
    void add(const T& one) {
        static_assert(std::is_trivially_copyable_v<T>);
        if constexpr (std::is_integral_v<T> || std::is_enum_v<T>)
            add_word(static_cast<uint64_t>(one));
        else
            add_bytes(&one, sizeof one);
    }
    void add(const std::string& text) { add_bytes(text.data(), text.size()); }
    template <class T>
    void add(const std::vector<T>& list) {
        add_word(list.size());
        for (const T& one : list) add(one);
    }
    template <class A, class B>
    void add(const std::pair<A, B>& both) {
        add(both.first);
        add(both.second);
    }
    template <class T>
    void add(const std::optional<T>& maybe) {
        add_word(maybe.has_value());
        if (maybe) add(*maybe);
    }

  private:
    void add_word(uint64_t word) {
        value = (value ^ word) * 0x9e3779b97f4a7c15u;
        value ^= value >> 29;
    }
};

template <class... Values>
uint64_t hash_of(const Values&... values) {
    Hash hash;
    (hash.add(values), ...);
    return hash.value;
}

}  // namespace lightwalk
