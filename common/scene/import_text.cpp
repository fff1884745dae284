#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>

#include "common/base/error.h"
#include "common/scene/asset_path.h"
#include "common/scene/import_parts.h"

namespace lightwalk {
namespace {

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// Properties that Assimp reads or that have no visual effect.
bool is_read(const std::string& element, const std::string& property) {
    if (element == "material") return true;
    if (element == "face")
        return is_one_of(property, {"vertex_indices", "vertex_index", "texcoord", "texnumber", "material_index"});
    return is_one_of(property, {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue",      "alpha",    "r",
                                "g", "b", "u", "v",  "s",  "t",  "tx",  "ty",    "texture_u", "texture_v"});
}

// f_rest_0 … f_rest_44 become "f_rest".
std::string without_number(std::string name) {
    while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back()))) name.pop_back();
    return name.ends_with('_') ? name.substr(0, name.size() - 1) : name;
}

void leave_out_property(const std::string& element, const std::string& property, Model& model) {
    if (element == "face" && is_one_of(property, {"red", "green", "blue", "alpha", "r", "g", "b"})) {
        if (property.starts_with('r')) leave_out(model, "colours of faces");
    } else {
        leave_out(model, without_number(property), element + " number");
    }
}

}  // namespace

std::string readable_ply(std::string text, const std::string& name, Model& model) {
    // Assimp loops endlessly without end_header.
    if (text.find("end_header") == text.npos)
        throw InputError("{}: no end_header, the file ends within its header", name);
    const size_t last = text.find("\nend_header");
    if (last == text.npos) return text;
    const size_t header = last + 1;
    std::istringstream lines(text.substr(0, header));
    std::string element, changed;
    std::set<std::string> elements;
    size_t textures = 0;
    for (std::string line; std::getline(lines, line); changed += line + "\n") {
        const std::vector<std::string> words = words_of(line);
        if (words.size() > 1 && words[0] == "comment" && words[1] == "TextureFile" && textures++ == 1)
            leave_out(model, "further textures");
        if (words.size() > 1 && words[0] == "element") {
            element = words[1];
            elements.insert(element);
            if (!is_one_of(element, {"vertex", "face", "material", "tristrips"}))
                leave_out(model, "element " + element);
        }
        if (words.empty() || words[0] != "property" || !is_one_of(element, {"vertex", "face", "material"})) continue;
        std::string property = words.back();
        if (element == "vertex" && property.starts_with("diffuse_")) {
            property.erase(0, 8);
            line.erase(line.rfind("diffuse_"), 8);
        }
        if (!is_read(element, property)) leave_out_property(element, property, model);
    }
    if (elements.contains("tristrips"))
        throw InputError("{}: its triangles are strips (element tristrips), expected faces", name);
    return changed + text.substr(header);
}

namespace {

class OffLines {
  public:
    OffLines(std::string_view text, const std::string& name) : in_{std::string(text)}, name_(name) {}

    bool next(std::vector<std::string>& words) {
        for (std::string line; std::getline(in_, line);) {
            ++number_;
            words = words_of(line.substr(0, line.find('#')));
            if (!words.empty()) return true;
        }
        return false;
    }

    template <class... Values>
    [[noreturn]] void refuse(fmt::format_string<Values...> format, Values&&... values) const {
        throw InputError("{}:{}: {}", name_, number_, fmt::format(format, std::forward<Values>(values)...));
    }

    double number(const std::string& word) const {
        char* end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end != '\0') refuse("'{}' is not a number", word.substr(0, 40));
        return value;
    }

  private:
    std::istringstream in_;
    const std::string& name_;
    size_t number_ = 0;
};

// Three or four components; empty: no colour.
using Color = std::vector<double>;

struct Off {
    size_t position = 3, normal = 0, uv = 0;
    std::vector<std::vector<std::string>> vertices;
    std::vector<Color> vertex_colors, face_colors;
    std::vector<std::vector<size_t>> faces;
    std::set<std::string> left_out;
};

// `otherwise`: name for Model::left_out if the numbers form no colour.
Color color_of(const OffLines& lines, const std::vector<std::string>& words, size_t first, size_t end,
               const char* otherwise, std::set<std::string>& left_out) {
    Color color;
    for (size_t i = first; i < end; ++i) color.push_back(lines.number(words[i]));
    if (color.empty() || color.size() == 3 || color.size() == 4) return color;
    left_out.insert(otherwise);
    return {};
}

size_t integer_of(const OffLines& lines, const std::string& word) {
    const double value = lines.number(word);
    if (!(value >= 0 && value <= 1e15 && value == std::floor(value)))
        lines.refuse("'{}' is not an integer from 0", word.substr(0, 40));
    return static_cast<size_t>(value);
}

std::pair<size_t, size_t> read_header(OffLines& lines, size_t bytes, Off& off) {
    std::vector<std::string> words;
    if (!lines.next(words)) lines.refuse("no header, expected OFF");
    if (std::string kind = words[0]; kind.ends_with("OFF")) {
        kind.resize(kind.size() - 3);
        const auto takes = [&](std::string_view letters) {
            const bool there = kind.starts_with(letters);
            if (there) kind.erase(0, letters.size());
            return there;
        };
        off.uv = takes("ST") ? 2 : 0;
        takes("C");
        off.normal = takes("N") ? 3 : 0;
        off.position = takes("4") ? 4 : 3;
        if (!kind.empty())
            lines.refuse("'{}', expected OFF with any of ST, C, N and 4 before it", words[0].substr(0, 40));
        words.erase(words.begin());
        if (!words.empty() && words[0] == "BINARY") lines.refuse("binary OFF, expected text");
        if (words.empty() && !lines.next(words)) lines.refuse("no counts after OFF");
    }
    if (words.size() < 2) lines.refuse("{} counts, expected those of vertices and faces", words.size());
    const size_t vertices = integer_of(lines, words[0]), faces = integer_of(lines, words[1]);
    if (std::max(vertices, faces) > bytes) lines.refuse("the header announces more elements than the file has bytes");
    return {vertices, faces};
}

Off read_off(std::string_view text, const std::string& name) {
    OffLines lines(text, name);
    Off off;
    const auto [vertices, faces] = read_header(lines, text.size(), off);
    const size_t least = off.position + off.normal;
    std::vector<std::string> words;
    for (size_t i = 0; i < vertices; ++i) {
        if (!lines.next(words)) lines.refuse("the file ends after {} of {} vertices", i, vertices);
        if (words.size() < least + off.uv) lines.refuse("{} numbers of a vertex, expected {}", words.size(), least);
        off.vertex_colors.push_back(
            color_of(lines, words, least, words.size() - off.uv, "further numbers of vertices", off.left_out));
        if (off.position == 4) {
            const double w = lines.number(words[3]);
            for (size_t k = 0; k < 3; ++k) words[k] = fmt::format("{}", lines.number(words[k]) / (w == 0 ? 1 : w));
        }
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(least),
                    words.end() - static_cast<std::ptrdiff_t>(off.uv));
        if (off.position == 4) words.erase(words.begin() + 3);
        for (const std::string& word : words) lines.number(word);
        off.vertices.push_back(words);
    }
    for (size_t i = 0; i < faces; ++i) {
        if (!lines.next(words)) lines.refuse("the file ends after {} of {} faces", i, faces);
        const size_t corners = integer_of(lines, words[0]);
        if (corners >= words.size()) lines.refuse("{} corners of a face, expected {}", words.size() - 1, corners);
        std::vector<size_t>& face = off.faces.emplace_back();
        for (size_t k = 1; k <= corners; ++k) {
            face.push_back(integer_of(lines, words[k]));
            if (face.back() >= vertices) lines.refuse("vertex {} of {}", face.back(), vertices);
        }
        off.face_colors.push_back(color_of(lines, words, corners + 1, words.size(), "colours by index", off.left_out));
    }
    return off;
}

}  // namespace

std::string off_as_ply(std::string_view text, const std::string& name, Model& model) {
    const Off off = read_off(text, name);
    for (const std::string& what : off.left_out) leave_out(model, what);
    const auto has = [](const Color& color) { return !color.empty(); };
    const bool by_face = std::any_of(off.face_colors.begin(), off.face_colors.end(), has);
    const bool by_vertex = !by_face && std::any_of(off.vertex_colors.begin(), off.vertex_colors.end(), has);
    if (by_face && std::any_of(off.vertex_colors.begin(), off.vertex_colors.end(), has))
        leave_out(model, "colours of vertices beside those of faces");
    double most = 0;  // above 1: range 0 to 255
    for (const auto* colors : {&off.vertex_colors, &off.face_colors})
        for (const Color& color : *colors)
            for (const double number : color) most = std::max(most, number);
    std::string rows, polygons;
    size_t count = 0;
    const auto add_vertex = [&](size_t vertex, const Color* color) {
        rows += fmt::format("{}", fmt::join(off.vertices[vertex], " "));
        for (size_t k = 0; color && k < 4; ++k)
            rows += fmt::format(" {}", k < color->size() ? (*color)[k] / (most > 1 ? 255 : 1) : 1.0);
        rows += "\n";
        return count++;
    };
    if (!by_face)
        for (size_t i = 0; i < off.vertices.size(); ++i) add_vertex(i, by_vertex ? &off.vertex_colors[i] : nullptr);
    for (size_t i = 0; i < off.faces.size(); ++i) {
        polygons += fmt::format("{}", off.faces[i].size());
        for (const size_t vertex : off.faces[i])
            polygons += fmt::format(" {}", by_face ? add_vertex(vertex, &off.face_colors[i]) : vertex);
        polygons += "\n";
    }
    std::string header = fmt::format("ply\nformat ascii 1.0\nelement vertex {}\n", count);
    for (const char* property : {"x", "y", "z", "nx", "ny", "nz", "s", "t", "red", "green", "blue", "alpha"}) {
        const std::string_view p = property;
        const bool is_there = p.starts_with('n')     ? off.normal > 0
                              : p == "s" || p == "t" ? off.uv > 0
                              : p.size() > 1         ? by_face || by_vertex
                                                     : true;
        if (is_there) header += fmt::format("property float {}\n", property);
    }
    return header +
           fmt::format("element face {}\nproperty list int int vertex_indices\nend_header\n", off.faces.size()) + rows +
           polygons;
}

std::vector<glm::vec4> stl_colors(std::string_view bytes, Model& model) {
    constexpr size_t header = 80, facet = 50;
    uint32_t count = 0;
    if (bytes.size() < header + 4) return {};
    std::memcpy(&count, &bytes[header], sizeof count);
    if (bytes.size() < header + 4 + facet * size_t{count}) return {};
    const size_t whole = bytes.substr(0, header).find("COLOR=");
    const bool magics = whole != bytes.npos && whole + 10 <= header;
    const auto code = [](unsigned number, float most) { return static_cast<float>(number) / most; };
    glm::vec4 usual(1);
    for (int k = 0; magics && k < 4; ++k)
        usual[k] = code(static_cast<unsigned char>(bytes[whole + 6 + static_cast<size_t>(k)]), 255);
    if (bytes.substr(0, header).find("MATERIAL=") != bytes.npos) leave_out(model, "MATERIAL of its header");
    std::vector<uint16_t> words(count);
    for (size_t i = 0; i < count; ++i) std::memcpy(&words[i], &bytes[header + 4 + facet * i + 48], sizeof words[i]);
    const bool all_zero = std::all_of(words.begin(), words.end(), [](uint16_t word) { return word == 0; });
    std::vector<glm::vec4> colors;
    bool any = magics;
    for (const uint16_t word : words) {
        // Bit 15 marks a valid colour in VisCAM files, the default colour in Magics files. All zeros: no colours.
        const bool own = (word >> 15 != 0) != magics && !all_zero;
        any |= own;
        const glm::vec3 low(code(word & 31u, 31), code(word >> 5 & 31u, 31), code(word >> 10 & 31u, 31));
        const glm::vec4 color = !own ? usual : glm::vec4(magics ? low : glm::vec3(low.b, low.g, low.r), 1);
        colors.insert(colors.end(), 3, color);
    }
    return any ? colors : std::vector<glm::vec4>();
}

std::string readable_obj(std::string_view text, const std::filesystem::path& folder) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::string readable;
    readable.reserve(text.size());
    while (!text.empty()) {
        const std::string_view line = text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1);
        text.remove_prefix(line.size());
        if (!line.starts_with("mtllib ")) {
            readable += line;
            continue;
        }
        std::string_view names = line.substr(7);
        while (names.ends_with('\n') || names.ends_with('\r')) names.remove_suffix(1);
        for (const std::filesystem::path& file : resolve_files(names, folder))
            readable += "mtllib " + file.lexically_relative(folder).string() + "\n";
    }
    return readable;
}

}  // namespace lightwalk
