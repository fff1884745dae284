#include "01_obj/obj.h"

#include <array>
#include <charconv>
#include <thread>

#include "01_obj/lines.h"
#include "01_obj/mtl.h"
#include "01_obj/scan.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/text.h"
#include "common/scene/import.h"

namespace lightwalk {
namespace {
namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> names = {"textbook", "tinyobjloader", "assimp", "scan", "parallel"};

constexpr std::string_view unfit_colors = "#MRGB colours, which are not as many as the vertices";
constexpr size_t most_bytes = size_t{1} << 40;
constexpr size_t searched_bytes = size_t{16} << 20;  // of files that ZBrush has not signed

// ZBrush writes colours as comments: "#MRGB " and eight hexadecimal digits for each vertex, of a mask and a colour.
void read_polypaint(std::string_view text, ObjData& data) {
    constexpr std::string_view mark = "#MRGB ";
    if (text.size() > searched_bytes && text.substr(0, 4096).find("ZBrush") == text.npos) return;
    std::vector<ColoredPosition> colors;
    for (size_t at = text.find(mark); at != text.npos; at = text.find(mark, at)) {
        const bool begins_line = at == 0 || text[at - 1] == '\n';
        at += mark.size();
        for (uint32_t number = 0; begins_line && at + 8 <= text.size(); at += 8) {
            const auto [end, error] = std::from_chars(&text[at], &text[at] + 8, number, 16);
            if (error != std::errc() || end != &text[at] + 8) break;
            const glm::vec3 color(number >> 16 & 255u, number >> 8 & 255u, number & 255u);
            colors.push_back({static_cast<uint32_t>(colors.size()), color / 255.0f});
        }
    }
    if (colors.size() == 0) return;
    if (colors.size() == data.positions.size() / 3)
        data.colors = std::move(colors);
    else
        data.left_out.emplace_back(unfit_colors);
}

ObjData parse(std::string_view text, const std::string& name, Loader loader, const ParseOptions& options) {
    text = without_mark(text);
    while (text.ends_with('\0')) text.remove_suffix(1);  // as ZBrush ends its files
    check_is_text(text, name);
    ObjData data;
    switch (loader) {
        case Loader::textbook:
            data = parse_textbook(text, name);
            break;
        case Loader::tinyobjloader:
        case Loader::assimp:
            data = parse_guarded(text, name, loader);
            break;
        case Loader::scan:
            data = parse_scan(text, name);
            break;
        case Loader::parallel:
            data = parse_parallel(text, name, options);
            break;
    }
    if (data.colors.empty()) read_polypaint(text, data);
    if (data.corners.empty()) throw InputError("{}:1: no face in the file, expected a line such as f 1 2 3", name);
    return data;
}

}  // namespace

std::string_view loader_name(Loader loader) { return names[static_cast<size_t>(loader)]; }

std::vector<std::string_view> loader_names() { return {names.begin(), names.end()}; }

Loader loader_from_name(std::string_view name) {
    std::string known;
    for (size_t i = 0; i < names.size(); ++i) {
        if (names[i] == name) return static_cast<Loader>(i);
        known += (i ? ", " : "") + std::string(names[i]);
    }
    throw InputError("unknown loader '{}'; there are: {}", name, known);
}

bool is_obj(const fs::path& path) {
    const std::string extension = path.extension();
    return extension == ".obj" || extension == ".OBJ" || extension == ".Obj";
}

ObjData parse_obj(const fs::path& path, Loader loader) {
    std::string text = read_file(path, most_bytes);
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const ParseOptions options{chunk_bytes_for(text.size(), cores), cores};
    return parse_obj_text(std::move(text), path.string(), loader, options);
}

ObjData parse_obj_text(std::string text, const std::string& name, Loader loader, ParseOptions options) {
    const size_t size = text.size();
    text.append(64, '\0');
    return parse(std::string_view(text).substr(0, size), name, loader, options);
}

Model load_obj(const fs::path& path, Loader loader, Tr tr) {
    if (loader == Loader::assimp) return import_model(path);
    const ObjData data = parse_obj(path, loader);
    Model model = weld(data, find_materials(data.materials, data.libraries, path.parent_path(), tr), path.stem());
    for (const std::string& what : data.left_out) leave_out(model, what);
    for (const Material& material : model.materials)
        for (const std::string& what : material.left_out) leave_out(model, what, "material");
    if (!model.left_out.empty()) warn_once(fmt::format("{}: left out: {}", path.string(), left_out_text(model)));
    return model;
}

Model load_model(const fs::path& path, Loader loader, Tr tr) {
    return is_obj(path) ? load_obj(path, loader, tr) : import_model(path);
}

}  // namespace lightwalk
