// One include for Catch2 2 (Debian 12) and 3 (Debian 13).
#pragma once
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#include <concepts>
#include <string>
#include <utility>

using Catch::Approx;
namespace Catch {
namespace Matchers {
// A text that contains another, which is ContainsSubstring in Catch2 3; its Contains looks for elements of a range.
template <typename T>
requires std::convertible_to<T, std::string>
auto Contains(T&& part) { return ContainsSubstring(std::string(std::forward<T>(part))); }
}  // namespace Matchers
using Matchers::Contains;
}  // namespace Catch
#else
#include <catch2/catch.hpp>
#endif
