// Values as bytes, to and from another process of the same build. Input is not trusted: lengths are checked, a bool
// is 0 or 1, and pointers are refused.
#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/base/error.h"

namespace lightwalk::wire {

inline constexpr size_t most_bytes = size_t(64) << 20;  ///< of one message

template <class T>
struct is_list : std::false_type {};
template <class T>
struct is_list<std::vector<T>> : std::true_type {};
template <class T, size_t n>
struct is_list<std::span<T, n>> : std::true_type {};
template <class T>
struct is_optional : std::false_type {};
template <class T>
struct is_optional<std::optional<T>> : std::true_type {};
template <class T>
struct is_pair : std::false_type {};
template <class A, class B>
struct is_pair<std::pair<A, B>> : std::true_type {};

/// glm's vectors and matrices: numbers and nothing else.
template <class T>
concept Numbers = requires {
    typename T::value_type;
    T::length();
}
&&std::is_trivially_copyable_v<T>;
template <class T>
concept Number = (std::is_arithmetic_v<T> || std::is_enum_v<T>)&&!std::is_same_v<T, bool>;
template <class T>
concept Text = std::is_same_v<T, std::string> || std::is_same_v<T, std::string_view>;
template <class T>
concept Record = std::is_class_v<T> && std::is_aggregate_v<T> && !Numbers<T> && !is_list<T>::value;

/// Stands for a value of any type, to count a record's members by.
struct Any {
    template <class T>
    operator T() const;
};

template <class T, class... Members>
constexpr size_t member_count() {
    if constexpr (sizeof...(Members) < 17 && requires { T{Members{}..., Any{}}; })
        return member_count<T, Members..., Any>();
    else
        return sizeof...(Members);
}

/// A tuple of references to a record's members; of more than 16, or where bases hide them, nothing.
template <class T>
constexpr auto members(T& r) {
    constexpr size_t count = member_count<std::remove_const_t<T>>();
#define LIGHTWALK_MEMBERS(number, ...) \
    if constexpr (count == number) {   \
        auto& [__VA_ARGS__] = r;       \
        return std::tie(__VA_ARGS__);  \
    } else
    LIGHTWALK_MEMBERS(1, a)
    LIGHTWALK_MEMBERS(2, a, b)
    LIGHTWALK_MEMBERS(3, a, b, c)
    LIGHTWALK_MEMBERS(4, a, b, c, d)
    LIGHTWALK_MEMBERS(5, a, b, c, d, e)
    LIGHTWALK_MEMBERS(6, a, b, c, d, e, f)
    LIGHTWALK_MEMBERS(7, a, b, c, d, e, f, g)
    LIGHTWALK_MEMBERS(8, a, b, c, d, e, f, g, h)
    LIGHTWALK_MEMBERS(9, a, b, c, d, e, f, g, h, i)
    LIGHTWALK_MEMBERS(10, a, b, c, d, e, f, g, h, i, j)
    LIGHTWALK_MEMBERS(11, a, b, c, d, e, f, g, h, i, j, k)
    LIGHTWALK_MEMBERS(12, a, b, c, d, e, f, g, h, i, j, k, l)
    LIGHTWALK_MEMBERS(13, a, b, c, d, e, f, g, h, i, j, k, l, m)
    LIGHTWALK_MEMBERS(14, a, b, c, d, e, f, g, h, i, j, k, l, m, n)
    LIGHTWALK_MEMBERS(15, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o)
    LIGHTWALK_MEMBERS(16, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p)
    return std::tuple<>();
#undef LIGHTWALK_MEMBERS
}

/// Whether a value can travel: numbers, texts, lists, optionals and records of such; no pointers, no functions, no
/// devices.
template <class T>
constexpr bool can_travel() {
    if constexpr (Number<T> || Numbers<T> || Text<T> || std::is_same_v<T, bool>) {
        return true;
    } else if constexpr (is_list<T>::value || is_optional<T>::value) {
        return can_travel<std::remove_const_t<typename T::value_type>>();
    } else if constexpr (is_pair<T>::value) {
        return can_travel<typename T::first_type>() && can_travel<typename T::second_type>();
    } else if constexpr (Record<T>) {
        using Members = decltype(members(std::declval<T&>()));
        return std::tuple_size_v<Members> > 0 && []<class... M>(std::type_identity<std::tuple<M...>>) {
            return (can_travel<std::remove_cvref_t<M>>() && ...);
        }(std::type_identity<Members>());
    } else {
        return false;
    }
}

/// A message would have more than most_bytes.
struct TooLarge {};

/// Numbers in a row, which are their own bytes. Of vector<bool> nothing is in a row.
template <class T>
constexpr bool flat() {
    return Number<T> || Numbers<T>;
}

template <class T>
void put(std::string& bytes, const T& value) {
    if constexpr (Number<T> || Numbers<T>) {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    } else if constexpr (std::is_same_v<T, bool>) {
        bytes.push_back(value ? 1 : 0);
    } else if constexpr (Text<T> || is_list<T>::value) {
        using One = std::remove_const_t<typename T::value_type>;
        put(bytes, uint64_t(value.size()));
        if (value.size() > most_bytes) throw TooLarge();
        if constexpr (flat<One>())
            bytes.append(reinterpret_cast<const char*>(value.data()), value.size() * sizeof(One));
        else
            for (const auto& one : value) put(bytes, static_cast<const One&>(one));
        if (bytes.size() > most_bytes) throw TooLarge();
    } else if constexpr (is_optional<T>::value) {
        put(bytes, value.has_value());
        if (value) put(bytes, *value);
    } else if constexpr (is_pair<T>::value) {
        put(bytes, value.first), put(bytes, value.second);
    } else {
        std::apply([&](const auto&... each) { (put(bytes, each), ...); }, members(value));
    }
}

/// Storage type of a received argument: text and lists own their data.
template <class T>
struct kept {
    using type = T;
};
template <>
struct kept<std::string_view> {
    using type = std::string;
};
template <class T, size_t n>
struct kept<std::span<T, n>> {
    using type = std::vector<std::remove_const_t<T>>;
};

/// Throws Failure if the bytes end too early.
template <class T>
void take(std::string_view& bytes, T& value) {
    if constexpr (Number<T> || Numbers<T>) {
        if (bytes.size() < sizeof value) throw Failure("an answer is cut off");
        std::memcpy(&value, bytes.data(), sizeof value);
        bytes.remove_prefix(sizeof value);
    } else if constexpr (std::is_same_v<T, bool>) {
        uint8_t byte = 0;
        take(bytes, byte);
        value = byte != 0;
    } else if constexpr (Text<T> || is_list<T>::value) {
        uint64_t count = 0;
        take(bytes, count);
        if (count > bytes.size()) throw Failure("an answer is cut off");  // each has a byte at least
        value.clear();
        if constexpr (flat<typename T::value_type>()) {
            if (count > bytes.size() / sizeof(typename T::value_type)) throw Failure("an answer is cut off");
            value.resize(count);
            if (count) std::memcpy(value.data(), bytes.data(), count * sizeof(typename T::value_type));
            bytes.remove_prefix(count * sizeof(typename T::value_type));
            return;
        }
        for (uint64_t i = 0; i < count; ++i) {
            typename T::value_type one{};
            take(bytes, one);
            value.push_back(std::move(one));
        }
    } else if constexpr (is_optional<T>::value) {
        bool has = false;
        take(bytes, has);
        if (has) take(bytes, value.emplace());
    } else if constexpr (is_pair<T>::value) {
        take(bytes, value.first), take(bytes, value.second);
    } else {
        std::apply([&](auto&... each) { (take(bytes, each), ...); }, members(value));
    }
}

}  // namespace lightwalk::wire
