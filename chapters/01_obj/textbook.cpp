// Loader in its simplest form: one line at a time, and a stream for every line. It is the slowest and the easiest to
// follow, and it calls this chapter's exercises.
#include <algorithm>
#include <locale>
#include <map>
#include <sstream>

#include "01_obj/exercises.h"
#include "01_obj/lines.h"
#include "01_obj/scan.h"

namespace lightwalk {
namespace {

std::istringstream words_of(const std::string& line) {
    std::istringstream words(line);
    words.imbue(std::locale::classic());  // a German locale takes the point for a thousands separator
    return words;
}

float number(const std::string& word) {
    float value = 0.0f;
    std::istringstream in = words_of(word);
    if (!(in >> value) || in.peek() != std::istringstream::traits_type::eof())
        throw InputError("{} is not a number that a float can hold", shown(word));
    return value;
}

std::vector<float> numbers(const std::string& line, size_t least, size_t most) {
    std::istringstream words = words_of(line);
    std::vector<float> values;
    std::string word;
    for (words >> word; words >> word && word[0] != '#';) values.push_back(number(word));
    if (values.size() < least || values.size() > most)
        throw InputError("{} numbers, expected {}{}", values.size(), least,
                         least == most ? "" : fmt::format(" to {}", most));
    return values;
}

// A statement: a line and its continuations after backslashes. Counts the lines; false at the end.
bool read_statement(std::istream& in, std::string& statement, size_t& line, size_t& next_line) {
    if (line = next_line; !std::getline(in, statement)) return false;
    ++next_line;
    statement = trim(statement);
    if (statement.starts_with('#')) statement.clear();
    for (std::string more; statement.ends_with('\\');) {
        statement.back() = ' ';
        if (!std::getline(in, more)) break;
        ++next_line;
        statement += trim(more);
    }
    return true;
}

// Numbers names in order of first use.
struct Numbering {
    std::map<std::string, uint32_t, std::less<>> numbers;
    uint32_t operator()(std::vector<std::string>& names, std::string_view name) {
        if (const auto it = numbers.find(name); it != numbers.end()) return it->second;
        names.emplace_back(name);
        return numbers[names.back()] = static_cast<uint32_t>(names.size() - 1);
    }
};

struct Face {
    std::vector<Corner> corners;
    Run names;
};

class Reader {
  public:
    explicit Reader(const Counts& total) : total_(total) {}

    void statement(const std::string& line) {
        std::string keyword;
        words_of(line) >> keyword;
        const std::string_view rest = trim(std::string_view(line).substr(keyword.size()));
        if (keyword == "v") {
            const VertexLine read = read_vertex(rest);
            // A colour that is no number is nothing that the exercise would have to know.
            const bool plain =
                line.find("nan") == line.npos && line.find("NaN") == line.npos && line.find("NAN") == line.npos;
            const glm::vec3 p =
                plain ? parse_vertex_line(line) : glm::vec3(read.position[0], read.position[1], read.position[2]);
            for (int i = 0; i < 3; ++i) data_.positions.push_back(p[i]);
            if (read.has_color)
                data_.colors.push_back({static_cast<uint32_t>(so_far_.positions), read.color, read.fourth});
            ++so_far_.positions;
        } else if (keyword == "vt") {
            std::vector<float> uv = numbers(line, 1, 3);
            uv.resize(2);
            for (const float x : uv) data_.uvs.push_back(x);
            ++so_far_.uvs;
        } else if (keyword == "vn") {
            for (const float x : numbers(line, 3, 3)) data_.normals.push_back(x);
            ++so_far_.normals;
        } else if (keyword == "f" || keyword == "fo") {
            // A uv or a normal may be one that the file does not have: checked() leaves it out.
            const Counts named{total_.positions, largest_index, largest_index};
            faces_.push_back({checked(parse_face(line, so_far_, named)), names_});
        } else if (keyword == "o") {
            names_.object = object_numbers_(data_.objects, rest);
        } else if (keyword == "g") {
            names_.group = group_numbers_(data_.groups, rest);
        } else if (keyword == "usemtl") {
            names_.material = material_numbers_(data_.materials, rest);
        } else if (keyword == "mtllib") {
            data_.libraries.emplace_back(rest);
        } else if (keyword == "s") {
            names_.smoothing = smoothing_group(rest);
        } else {
            check_keyword(keyword);
            const std::string what(left_out_of(keyword));
            if (!what.empty() && std::find(data_.left_out.begin(), data_.left_out.end(), what) == data_.left_out.end())
                data_.left_out.push_back(what);
        }
    }

    bool absent() const { return absent_; }

    ObjData finish(const std::string& name) {
        CuttingTime time(name);
        data_.runs = {Run()};
        for (Face& face : faces_) {
            face.names.first_triangle = static_cast<uint32_t>(data_.triangles());
            add_run(data_.runs, face.names);
            const size_t count = face.corners.size();
            const size_t first = data_.corners.size();
            data_.corners.resize(first + 3 * (count - 2));
            Corner* const out = &data_.corners[first];
            if (count == 3)
                std::copy_n(face.corners.data(), 3, out);
            else
                time.count(count, [&] {
                    cut_polygon(triangulate.function(), face.corners.data(), count, data_.positions, out);
                });
        }
        return std::move(data_);
    }

  private:
    // A student's parse_face may return anything, and its result is used as an index.
    std::vector<Corner> checked(std::vector<Corner> corners) {
        const auto leave_out = [this](uint32_t& index, size_t count) {
            if (index == none || index < count) return;
            index = none;
            absent_ = true;
        };
        for (Corner& c : corners) {
            if (c.position >= total_.positions) throw InputError("parse_face returned an index that is out of range");
            leave_out(c.uv, total_.uvs);
            leave_out(c.normal, total_.normals);
        }
        if (corners.size() < 3) throw InputError("parse_face returned fewer than 3 corners");
        if (corners.size() > most_corners)
            throw InputError("a face with {} corners, at most {} are cut", corners.size(), most_corners);
        return corners;
    }

    Counts so_far_, total_;
    ObjData data_;
    Numbering object_numbers_, group_numbers_, material_numbers_;
    std::vector<Face> faces_;
    Run names_;
    bool absent_ = false;
};

}  // namespace

ObjData parse_textbook(std::string_view text, const std::string& name) {
    Reader reader(count_elements(text));
    std::istringstream in{std::string(text)};
    std::string statement;
    for (size_t line = 1, next_line = 1; read_statement(in, statement, line, next_line);) try {
            statement = trim(statement);
            if (!statement.empty()) reader.statement(statement);
        } catch (const InputError& error) { fail_at(name, line, error.what()); }
    if (reader.absent()) warn_of_absent(text, name);
    return reader.finish(name);
}

}  // namespace lightwalk
