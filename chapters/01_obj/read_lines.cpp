// Common forms of v, vt, vn and f, read eight characters at a time. All other lines go to the scanner.
#include "01_obj/fast_parse.h"
#include "01_obj/lines.h"
#include "01_obj/scan.h"

namespace lightwalk {
namespace {

const char* end_of_line(const char* at) {
    if (*at == '\r') ++at;
    return *at == '\n' ? at + 1 : nullptr;
}

// `count` numbers with one space before each. Returns the next line, or null for any other form.
template <int count>
const char* read_numbers(const char* at, float* values) {
    for (int i = 0; i < count; ++i) {
        if (*at != ' ') return nullptr;
        if (!(at = fast_float(at + 1, values[i]))) return nullptr;
    }
    return end_of_line(at);
}

template <int count>
const char* numbers_line(const char* at, std::vector<float>& into) {
    float values[count];
    at = read_numbers<count>(at, values);
    if (at) into.insert(into.end(), values, values + count);
    return at;
}

template <bool has_uv, bool has_normal>
const char* read_corner(const char* at, Corner& c) {
    if (!(at = fast_index(at, c.position))) return nullptr;
    if (has_uv || has_normal)
        if (*at++ != '/') return nullptr;
    if (has_uv && !(at = fast_index(at, c.uv))) return nullptr;
    if (has_normal && (*at != '/' || !(at = fast_index(at + 1, c.normal)))) return nullptr;
    c = {c.position - 1, has_uv ? c.uv - 1 : none, has_normal ? c.normal - 1 : none};
    return at;
}

// A face with all corners in the first one's form, with positive indices.
template <bool has_uv, bool has_normal>
const char* read_corners(const char* at, Collected& into) {
    const size_t first = into.corners.size();
    for (Corner c; at && *at == ' ';)
        if ((at = read_corner<has_uv, has_normal>(at + 1, c))) into.corners.push_back(c);
    const size_t count = into.corners.size() - first;
    if (!at || count < 3 || count > most_corners || !(at = end_of_line(at))) {
        into.corners.resize(first);
        return nullptr;
    }
    into.sizes.push_back(static_cast<uint32_t>(count));
    return at;
}

const char* face_line(const char* at, Collected& into) {
    // The first corner says which of the four forms it is.
    const char* p = at + 1;
    while (*p >= '0' && *p <= '9') ++p;
    if (*p != '/') return read_corners<false, false>(at, into);
    if (*++p == '/') return read_corners<false, true>(at, into);
    while (*p >= '0' && *p <= '9') ++p;
    return *p == '/' ? read_corners<true, true>(at, into) : read_corners<true, false>(at, into);
}

}  // namespace

void reserve(Collected& into, size_t text_bytes) {
    into.corners.reserve(text_bytes / 16);
    for (std::vector<float>* values : {&into.positions, &into.uvs, &into.normals}) values->reserve(text_bytes / 16);
    into.sizes.reserve(text_bytes / 32);
}

Piece read_lines(std::string_view text, Collected& into) {
    Scanner scanner(into);
    const char* at = text.data();
    const char* const end = at + text.size();
    while (at < end) {
        const char* next = nullptr;
        if (at[0] == 'v') {
            if (at[1] == ' ')
                next = numbers_line<3>(at + 1, into.positions);
            else if (at[1] == 't' && at[2] == ' ')
                next = numbers_line<2>(at + 2, into.uvs);
            else if (at[1] == 'n' && at[2] == ' ')
                next = numbers_line<3>(at + 2, into.normals);
        } else if (at[0] == 'f' && at[1] == ' ') {
            next = face_line(at + 1, into);
        }
        if (!next) {
            Statements statements(std::string_view(at, static_cast<size_t>(end - at)));
            if (std::string_view statement; statements.next(statement)) scanner.statement(statement);
            next = statements.rest().data();
        }
        at = next;
    }
    return scanner.piece();
}

}  // namespace lightwalk
