// Exercise 01.parse_face: the corners of a face, such as
//     f 1/1/1 2/2/1 3/3/1
// As it stands this reads the positions of the first three corners, and nothing else.
#include <cstdlib>
#include <sstream>
#include <string>

#include "01_obj/exercises.h"
#include "common/base/error.h"  // InputError

namespace lightwalk::exercise {

// [parse_face]
// The corners on a line `f c c c ...`, each `v`, `v/vt`, `v//vn` or `v/vt/vn`, as indices from 0; what a corner leaves
// out is `none`. Words are parted by spaces and tabs; a word that begins with # begins a comment, to the line's end. In
// the file 1 is the first one and -1 the last one read so far, which `so_far` counts. `total` counts the whole file's:
// a face may use what comes later. Throws InputError with the reason alone (the caller adds file and line) where there
// are fewer than three corners, and where an index is 0, not a whole number, or out of range, however long it is.
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
