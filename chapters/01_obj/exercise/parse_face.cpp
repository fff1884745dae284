// Exercise 01.parse_face: the corners of a face, such as
//     f 1/1/1 2/2/1 3/3/1
// As it stands this reads the positions of the first three corners, and nothing else.
#include <cstdlib>
#include <sstream>
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
