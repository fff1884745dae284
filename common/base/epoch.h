// Change tracking for derived data.
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

/// Counter of changes from outside that are not undone: an edited file, a scene that was loaded, edited or moved.
class Epoch {
  public:
    static uint64_t next() { return ++last(); }

  private:
    static std::atomic<uint64_t>& last() {
        static std::atomic<uint64_t> epoch{0};
        return epoch;
    }
};

/// Hash of numbers, glm vectors, pointers, text, structures without padding, and lists, pairs and optionals of these.
template <class... Values>
uint64_t hash_of(const Values&... values);

/// Fingerprint of the inputs of a derived table, buffer or picture:
///
///     if (made_.is_current(epoch(), scene.epoch)) return;
///     // ... rebuild
///
/// Inputs are the epochs of what is read, and values that change per frame: time, camera, size.
class Fingerprint {
  public:
    /// False if the inputs differ from the last call's: rebuild now.
    template <class... Inputs>
    [[nodiscard]] bool is_current(const Inputs&... inputs) {
        const uint64_t now = hash_of(inputs...);
        return std::exchange(from_, now) == now;
    }
    void forget() { from_.reset(); }
    explicit operator bool() const { return from_.has_value(); }

  private:
    std::optional<uint64_t> from_;
};

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
