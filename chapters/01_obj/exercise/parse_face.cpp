// Exercise 01.parse_face: the corners of a face, such as
//     f 1/1/1 2/2/1 3/3/1
// As it stands this reads the first three positions of a line `f 1 2 3`, and nothing else.
#include <cstdlib>
#include <string>

#include "01_obj/exercises.h"

namespace lightwalk::exercise {

std::vector<Corner> parse_face(std::string_view line, const Counts& so_far, const Counts& total) {
    // 1. Read every corner, not only three: a face may have any number.
    // 2. A corner is v, v/vt, v//vn or v/vt/vn. What is missing stays `none`.
    // 3. The file counts from 1, a Corner from 0. A negative index counts back from the last one read so far:
    //    -1 is so_far.positions - 1 (so_far.uvs - 1, so_far.normals - 1).
    // 4. Throw InputError("what is wrong") for fewer than three corners, for index 0, for what is no whole number, and
    //    for an index beyond `total`. A face may use a vertex that the file gives later.
    (void)so_far;
    std::vector<Corner> corners;
    const std::string text(line.substr(1));
    const char* at = text.c_str();
    for (int i = 0; i < 3; ++i) {
        char* end = nullptr;
        const long index = std::strtol(at, &end, 10);
        const bool exists = index >= 1 && static_cast<size_t>(index) <= total.positions;
        corners.push_back({.position = exists ? static_cast<uint32_t>(index - 1) : 0});
        at = end;
    }
    return corners;
}

}  // namespace lightwalk::exercise
