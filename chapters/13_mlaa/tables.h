// Tables of the filters, and their computation.
#pragma once
#include <cstddef>
#include <vector>

namespace lightwalk {

inline constexpr int longest_reach = 255;  ///< limit of a byte

/// [(to_other - 1) * longest_reach + to_end - 1]: the share of a pixel that lies `to_end` pixels from the end of a line
/// at which the outline turns, and `to_other` pixels from its other end; itself counted both times. By
/// exercise 13.area.
std::vector<float> area_table();

/// [4 * at_other + at_end]: the side to which an outline turns at an end of a line: -1 the near one, 1 the far one, 0
/// none. Index: crossing edges there and at the other end: 0 nothing, 1 an edge on the near side, 2 on the far side,
/// 3 both. With both, two outlines cross: each continues from one side of the line to the other.
std::vector<float> crossing_table();

}  // namespace lightwalk
