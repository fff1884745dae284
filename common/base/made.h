// The inputs of something that is kept, and made again when they change.
#pragma once
#include <concepts>
#include <cstring>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace lightwalk {

// [made]
/// The inputs of a derived table, buffer or picture. Its type declares them, and they are compared as values:
///
///     Made<uint64_t, int, float> light_made_;  // the field's number, steps, step_m
///     if (!light_made_.from(field.number(), steps.value, step_m)) return;
///     // ... makes it
///
/// Structs without == are compared by their bytes.
template <class... Inputs>
class Made {
  public:
    /// True if an input changed since the last call, or nothing was made yet: make it now.
    [[nodiscard]] bool from(const Inputs&... now) {
        if (inputs_ && same(*inputs_, std::tie(now...), std::index_sequence_for<Inputs...>())) return false;
        inputs_.emplace(now...);
        return true;
    }

    /// Forces the next from() to return true, after a loss or a failure.
    void forget() { inputs_.reset(); }

    explicit operator bool() const { return inputs_.has_value(); }

    /// The inputs it was made from; it was made.
    const auto& inputs() const {
        if constexpr (sizeof...(Inputs) == 1)
            return std::get<0>(*inputs_);
        else
            return *inputs_;
    }

  private:
    template <class T>
    static bool same(const T& a, const T& b) {
        if constexpr (requires {
                          { a == b } -> std::convertible_to<bool>;
                      }) {
            return a == b;
        } else {
            static_assert(std::is_trivially_copyable_v<T>);
            return std::memcmp(&a, &b, sizeof a) == 0;
        }
    }
    template <class Before, class Now, size_t... i>
    static bool same(const Before& before, const Now& now, std::index_sequence<i...>) {
        return (same(std::get<i>(before), std::get<i>(now)) && ...);
    }

    std::optional<std::tuple<Inputs...>> inputs_;
};
// [/made]

}  // namespace lightwalk
