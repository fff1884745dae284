// Tables of the filters, and their computation.
#pragma once
#include <cstddef>
#include <vector>

namespace lightwalk {

inline constexpr int longest_reach = 255;  ///< what a byte holds

/// [(to_other - 1) * longest_reach + to_end - 1]: the share of a pixel that lies `to_end` pixels from the end of a line
/// at which the outline turns, and `to_other` pixels from its other end; itself counted both times. By
/// exercise 13.area.
std::vector<float> area_table();

/// [4 * at_other + at_end]: to which side an outline turns at an end of a line: -1 the near one, 1 the far one, 0 none.
/// By what stands across the line there and at the other end: 0 nothing, 1 an edge on the near side, 2 on the far side,
/// 3 both. Where it is both, an outline crosses another one: it goes on from one side of the line to the other.
std::vector<float> crossing_table();

}  // namespace lightwalk
