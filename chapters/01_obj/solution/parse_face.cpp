#include <charconv>

#include "01_obj/exercises.h"
#include "01_obj/lines.h"

namespace lightwalk::solution {
namespace {

// Takes one index off the front of `word`.
uint32_t read_index(std::string_view& word, size_t so_far, size_t total) {
    int64_t index = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error == std::errc::invalid_argument)
        throw InputError("{} is not an index; a corner is v, v/vt, v//vn or v/vt/vn", shown(word));
    word.remove_prefix(static_cast<size_t>(stop - word.data()));
    if (error == std::errc() && index == 0) throw InputError("index 0; the first one is 1");
    const int64_t from_zero = index > 0 ? index - 1 : static_cast<int64_t>(so_far) + index;
    if (error != std::errc() || from_zero < 0 || from_zero >= static_cast<int64_t>(total))
        throw InputError("an index is out of range, there are {}", total);
    return static_cast<uint32_t>(from_zero);
}

}  // namespace

std::vector<Corner> parse_face(std::string_view line, const Counts& so_far, const Counts& total) {
    next_word(line);  // the f
    std::vector<Corner> corners;
    for (std::string_view word; !(word = next_value(line)).empty();) {
        Corner corner;
        corner.position = read_index(word, so_far.positions, total.positions);
        if (word.starts_with('/')) {
            word.remove_prefix(1);
            if (!word.starts_with('/')) corner.uv = read_index(word, so_far.uvs, total.uvs);
            if (word.starts_with('/')) {
                word.remove_prefix(1);
                if (!word.empty()) corner.normal = read_index(word, so_far.normals, total.normals);
            }
        }
        if (!word.empty()) throw InputError("{} after a corner; write v, v/vt, v//vn or v/vt/vn", shown(word));
        corners.push_back(corner);
    }
    if (corners.size() < 3) throw InputError("a face with fewer than 3 corners: {}", corners.size());
    return corners;
}

}  // namespace lightwalk::solution
