#include "01_obj/scan.h"

#include <algorithm>
#include <charconv>

#include "01_obj/fast_parse.h"
#include "01_obj/lines.h"
#include "common/base/text.h"

namespace lightwalk {
namespace {

const char* plural(size_t count) { return count == 1 ? "" : "s"; }

// The number that a word is.
float float_or_throw(std::string_view word) {
    float value = 0.0f;
    switch (parse_float(word, value)) {
        case FloatStatus::ok:
            break;
        case FloatStatus::not_a_number:
            throw InputError("{} is not a number such as -1.5 or 2e-3", shown(word));
        case FloatStatus::too_large:
            throw InputError("{} is too large for a float, at most 3.4028e38", shown(word));
    }
    return value;
}

// Reads `least` to `most` numbers; returns how many.
int read_floats(std::string_view rest, int least, int most, float* values, std::string_view usage) {
    int count = 0;
    for (;; ++count) {
        const std::string_view word = next_value(rest);
        if (word.empty()) break;
        if (count == most) throw InputError("too many numbers, expected {}", usage);
        values[count] = float_or_throw(word);
    }
    if (count < least) throw InputError("{} number{}, expected {}", count, plural(static_cast<size_t>(count)), usage);
    return count;
}

}  // namespace

uint32_t Scanner::index(std::string_view& word, size_t so_far, size_t total, const char* what) {
    int64_t number = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc::invalid_argument)
        throw InputError("{} is not an index; a corner is v, v/vt, v//vn or v/vt/vn", shown(word));
    const std::string_view digits(word.data(), static_cast<size_t>(stop - word.data()));
    word.remove_prefix(digits.size());
    if (number == 0 && error == std::errc()) throw InputError("index 0; the first {} is 1", what);
    if (error != std::errc() || number > largest_index || number < -largest_index)
        throw InputError("index {} is out of range", digits.substr(0, 40));
    const int64_t from_start = number > 0 ? number - 1 : static_cast<int64_t>(so_far) + number;
    if (total_ && (from_start < 0 || from_start >= static_cast<int64_t>(total)))
        throw InputError("index {} is out of range, there {}{} {}{}{}", digits, total == 1 ? "is " : "are ",
                         number < 0 ? so_far : total, what, plural(total), number < 0 ? " before it" : "");
    return number > 0 ? static_cast<uint32_t>(from_start) : relative_index(from_start);
}

// A position that is not there leaves no face. A uv or a normal is a pity, and other programs read such files.
uint32_t Scanner::optional_index(std::string_view& word, size_t so_far, size_t total, const char* what) {
    if (!total_) return index(word, so_far, total, what);
    int64_t number = 0;
    std::from_chars(word.data(), word.data() + word.size(), number);
    if (number <= static_cast<int64_t>(total) || number > largest_index) return index(word, so_far, total, what);
    word.remove_prefix(std::min(word.find_first_not_of("0123456789"), word.size()));
    ++absent_;
    return none;
}

void Scanner::face(std::string_view rest) {
    const size_t positions = (out_.positions.size() - start_.positions) / 3;
    const size_t uvs = (out_.uvs.size() - start_.uvs) / 2, normals = (out_.normals.size() - start_.normals) / 3;
    const Counts total = total_ ? *total_ : Counts();
    const size_t first = out_.corners.size();
    for (;;) {
        std::string_view word = next_value(rest);
        if (word.empty()) break;
        const std::string_view whole = word;
        Corner corner;
        corner.position = index(word, positions, total.positions, "position");
        if (word.starts_with('/')) {  // the last index may be missing: Wings3D writes v//
            word.remove_prefix(1);
            if (!word.starts_with('/')) corner.uv = optional_index(word, uvs, total.uvs, "uv");
            if (word.starts_with('/')) {
                word.remove_prefix(1);
                if (!word.empty()) corner.normal = optional_index(word, normals, total.normals, "normal");
            }
        }
        if (!word.empty()) throw InputError("{} is not a corner; write v, v/vt, v//vn or v/vt/vn", shown(whole));
        out_.corners.push_back(corner);
    }
    const size_t count = out_.corners.size() - first;
    if (count < 3) throw InputError("a face with {} corner{}, expected 3 or more", count, plural(count));
    if (count > most_corners) throw InputError("a face with {} corners, at most {} are cut", count, most_corners);
    out_.sizes.push_back(static_cast<uint32_t>(count));
}

void Scanner::statement(std::string_view text) {
    std::string_view rest = text;
    const std::string_view keyword = next_word(rest);
    const auto name_line = [&](NameLine::Kind kind) {
        names_.push_back({kind, out_.sizes.size() - start_.sizes, std::string(trim(rest))});
    };
    float values[3] = {};
    if (keyword == "v") {
        const VertexLine vertex = read_vertex(rest);
        if (vertex.has_color)
            out_.colors.push_back({static_cast<uint32_t>(out_.positions.size() / 3), vertex.color, vertex.fourth});
        out_.positions.insert(out_.positions.end(), vertex.position, vertex.position + 3);
    } else if (keyword == "vt") {
        read_floats(rest, 1, 3, values, "vt u v");
        out_.uvs.insert(out_.uvs.end(), values, values + 2);
    } else if (keyword == "vn") {
        read_floats(rest, 3, 3, values, "vn x y z");
        out_.normals.insert(out_.normals.end(), values, values + 3);
    } else if (keyword == "f" || keyword == "fo") {
        face(rest);
    } else if (keyword == "o") {
        name_line(NameLine::object);
    } else if (keyword == "g") {
        name_line(NameLine::group);
    } else if (keyword == "usemtl") {
        name_line(NameLine::material);
    } else if (keyword == "mtllib") {
        name_line(NameLine::library);
    } else if (keyword == "s") {
        name_line(NameLine::smoothing);
    } else {
        check_keyword(keyword);
        const std::string_view what = left_out_of(keyword);
        if (what.empty() || (!names_.empty() && names_.back().name == what)) return;
        names_.push_back({NameLine::left_out, out_.sizes.size() - start_.sizes, std::string(what)});
    }
}

std::string_view left_out_of(std::string_view keyword) {
    // Of free forms, which are named by their curves and surfaces, and of the display of other programs.
    static constexpr std::string_view silent[] = {
        "vp",         "cstype",    "deg", "bmat",  "step",     "parm",     "trim", "hole", "scrv",
        "sp",         "end",       "con", "bevel", "c_interp", "d_interp", "lod",  "mg",   "ctech",
        "shadow_obj", "trace_obj", "bzp", "bsp",   "cdc",      "cdp",      "res",  "stech"};
    if (keyword == "l") return "lines";
    if (keyword == "p") return "points";
    if (keyword == "curv" || keyword == "curv2" || keyword == "surf") return "free-form curves and surfaces";
    return std::find(std::begin(silent), std::end(silent), keyword) == std::end(silent) ? keyword : "";
}

uint32_t smoothing_group(std::string_view name) {
    uint32_t group = 0;
    std::from_chars(name.data(), name.data() + name.size(), group);
    return std::min(group, none - 1);
}

VertexLine read_vertex(std::string_view rest) {
    static constexpr const char* usage = "v x y z, optionally followed by w, r g b, or both";
    VertexLine vertex;
    float values[7] = {};
    bool numbers[7] = {};
    int count = 0;
    for (;; ++count) {
        const std::string_view word = next_value(rest);
        if (word.empty()) break;
        if (count == 7) throw InputError("too many numbers, expected {}", usage);
        numbers[count] = parse_float(word, values[count]) == FloatStatus::ok;
        const bool is_nan =
            word.find("nan") != word.npos || word.find("NAN") != word.npos || word.find("NaN") != word.npos;
        if (!numbers[count] && (count < 3 || !is_nan)) float_or_throw(word);
    }
    if (count < 3) throw InputError("{} number{}, expected {}", count, plural(static_cast<size_t>(count)), usage);
    if (count == 5) throw InputError("5 numbers, expected {}", usage);
    std::copy_n(values, 3, vertex.position);
    const int first = count - 3;
    vertex.has_color = count >= 6 && numbers[first] && numbers[first + 1] && numbers[first + 2];
    if (vertex.has_color) vertex.color = {values[first], values[first + 1], values[first + 2]};
    if (vertex.has_color && count == 7 && numbers[3]) vertex.fourth = values[3];
    return vertex;
}

void check_keyword(std::string_view keyword) {
    for (size_t i = 0; i < keyword.size(); ++i)
        if (const char c = keyword[i];
            !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (i >= 3 && c >= '0' && c <= '9')))
            throw InputError("{} is not a statement; a line starts with a word such as v, vt, vn or f", shown(keyword));
}

Piece Scanner::piece() { return {&out_, start_, mark(out_), std::move(names_)}; }

void check_is_text(std::string_view text, const std::string& name) {
    if (trim(text).empty()) throw InputError("{}:1: the file is empty, expected OBJ text", name);
    if (text.substr(0, 4096).find('\0') != text.npos)
        throw InputError("{}:1: the file is binary, expected OBJ text", name);
    check_line_ends(text, name);
}

Counts count_elements(std::string_view text) {
    Counts counts;
    Statements statements(text);
    for (std::string_view statement; statements.next(statement);) {
        const std::string_view keyword = next_word(statement);
        counts.positions += keyword == "v";
        counts.uvs += keyword == "vt";
        counts.normals += keyword == "vn";
    }
    return counts;
}

namespace {

// Calls after(scanner, line) for each statement of a text that is scanned with every index checked.
template <class After>
void scan_again(std::string_view text, const std::string& name, const After& after) {
    const Counts total = count_elements(text);
    Collected collected;
    Scanner scanner(collected, &total);
    Statements statements(text);
    for (std::string_view statement; statements.next(statement);) try {
            scanner.statement(statement);
            after(scanner, statements.line());
        } catch (const InputError& error) { fail_at(name, statements.line(), error.what()); }
}

}  // namespace

void throw_first_error(std::string_view text, const std::string& name) {
    scan_again(text, name, [](const Scanner&, size_t) {});
    throw InputError("{}: more than {} elements or triangles", name, largest_index);
}

void warn_of_absent(std::string_view text, const std::string& name) {
    size_t first = 0, count = 0;
    scan_again(text, name, [&](const Scanner& scanner, size_t line) {
        if (count == 0 && scanner.absent() > 0) first = line;
        count = scanner.absent();
    });
    if (count > 0)
        warn_once(
            fmt::format("{}:{}: names a uv or a normal that the file does not have ({} in the file); left out, "
                        "normals are computed",
                        name, first, count));
}

// One chunk on one thread.
ObjData parse_scan(std::string_view text, const std::string& name) {
    return parse_parallel(text, name, {.chunk_bytes = text.size() + 1, .threads = 1});
}

}  // namespace lightwalk
