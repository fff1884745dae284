// Exercise 01.parse_face: the corners of a face, such as
//     f 1/1/1 2/2/1 3/3/1
// Starter: the function reads the positions of the first three corners and nothing else.
#include <cstdlib>
#include <sstream>
#include <string>

#include "01_obj/exercises.h"
#include "common/base/error.h"  // InputError

namespace lightwalk::exercise {

// [parse_face]
// Returns the corners on one line `f c c c ...`. Each corner is `v`, `v/vt`, `v//vn` or
// `v/vt/vn`. The returned indices count from 0; an index that a corner leaves out is `none`,
// and the slash before a normal may end it (`v//`, `v/vt/`); `v/` may be read or refused.
// Spaces and tabs separate words. A word that begins with # starts a comment, which runs to
// the end of the line.
// In the file, 1 is the first element, and -1 is the last element read so far: `so_far`
// counts the elements before this line. `total` counts those of the whole file: a positive
// index may refer to an element that comes later. Throws InputError with the reason alone
// (the caller adds file and line) if there are fewer than three corners, or if an index is
// 0, not an integer, or out of range, however many digits it has.
// [/parse_face]
std::vector<Corner> parse_face(std::string_view line, const Counts& so_far, const Counts& total) {
    // 1. Read every corner, not only three: a face may have any number.
    // 2. Take v, vt and vn off each; -1 is so_far.positions - 1 (so_far.uvs - 1, so_far.normals - 1).
    // 3. Look at the range before you narrow to 32 bits. Where something is wrong: throw InputError("what is wrong");
    (void)so_far;
    std::vector<Corner> corners(3, Corner{.position = 0});
    std::istringstream words(std::string(line.substr(1)));
    std::string word;
    for (Corner& corner : corners) {
        words >> word;
        const long index = std::strtol(word.c_str(), nullptr, 10);
        if (index >= 1 && static_cast<size_t>(index) <= total.positions)
            corner.position = static_cast<uint32_t>(index - 1);
    }
    return corners;
}

}  // namespace lightwalk::exercise
