// Chapters of the menu and their pictures.
#include "common/window/menu_chapters.h"

#include <algorithm>
#include <fstream>
#include <utility>

#include "common/app/shots.h"
#include "common/base/files.h"
#include "common/image/image.h"
#include "common/window/lesson_pages.h"

namespace lightwalk {

namespace {

namespace fs = std::filesystem;

constexpr glm::uvec2 tile_size{384, 216};  ///< pixels at scale 1; shown smaller or larger

// The chapter's best picture: as the gallery drew it, with four samples, else as accepted.
std::optional<fs::path> find_picture(const std::string& chapter, const fs::path& build) {
    std::vector<Shot> shots;
    try {
        shots = best_first(chapter);
    } catch (const std::exception&) {
        return std::nullopt;  // the chapter's program reports the error
    }
    for (const Shot& shot : shots)
        for (const fs::path& folder : {build / "gallery" / chapter, course_root() / "tests" / chapter / "golden"})
            if (fs::exists(folder / (shot.name + ".png"))) return folder / (shot.name + ".png");
    return std::nullopt;
}

// The middle of the image, resized to a tile: each pixel averages its area in linear light.
Image8 thumbnail(const Image8& image, glm::uvec2 size) {
    const ImageRgb linear = to_linear(image);
    const float scale = std::min(float(image.width) / float(size.x), float(image.height) / float(size.y));
    const glm::vec2 corner = 0.5f * (glm::vec2(image.width, image.height) - scale * glm::vec2(size));
    ImageRgb tile(static_cast<int>(size.x), static_cast<int>(size.y));
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const glm::ivec2 limit(image.width - 1, image.height - 1);
            const glm::ivec2 begin = glm::clamp(glm::ivec2(corner + scale * glm::vec2(x, y)), glm::ivec2(0), limit);
            const glm::ivec2 end =
                glm::clamp(glm::ivec2(corner + scale * glm::vec2(x + 1, y + 1)), begin + 1, limit + 1);
            glm::vec3 sum(0.0f);
            for (int v = begin.y; v < end.y; ++v)
                for (int u = begin.x; u < end.x; ++u) sum += linear.at(u, v);
            tile.at(x, y) = sum / static_cast<float>((end.x - begin.x) * (end.y - begin.y));
        }
    return to_srgb8(tile);
}

}  // namespace

std::vector<MenuEntry> find_chapters(Gpu& gpu, float scale, const MenuPrograms& programs) {
    const fs::path build = fs::read_symlink("/proc/self/exe").parent_path();
    std::vector<MenuEntry> entries;
    for (const auto& [name, state] : programs.states())
        entries.push_back({name, chapter_title(name), build / "chapters" / name, {}});
    for (const auto& file : fs::directory_iterator(build / "chapters")) {
        const std::string name = file.path().filename().string();
        if (!file.is_regular_file() || file.path().has_extension() || name.size() < 4 || name[2] != '_') continue;
        if (!programs.states().contains(name)) entries.push_back({name, chapter_title(name), file.path(), {}});
    }
    std::sort(entries.begin(), entries.end(),
              [](const MenuEntry& a, const MenuEntry& b) { return a.chapter < b.chapter; });
    const glm::uvec2 size(glm::vec2(tile_size) * scale);
    for (MenuEntry& entry : entries)
        if (const auto file = find_picture(entry.chapter, build)) {
            const Image8 picture = thumbnail(read_image8(*file), size);
            entry.picture =
                Image(gpu.device, {.name = entry.chapter, .format = VK_FORMAT_R8G8B8A8_UNORM, .size = size});
            gpu.upload(entry.picture, std::as_bytes(std::span(picture.pixels)));
        }
    return entries;
}

MenuPrograms::MenuPrograms(std::filesystem::path folder) : folder_(std::move(folder)) { poll(); }

bool MenuPrograms::poll() {
    if (folder_.empty()) return false;
    std::ifstream file(folder_ / "states");
    std::map<std::string, ProgramState> states;
    std::string chapter;
    for (ProgramState state; file >> chapter >> state.name >> state.done >> state.total;) states[chapter] = state;
    if (states.empty() || states == states_) return false;
    states_ = std::move(states);
    return true;
}

bool MenuPrograms::are_building() const {
    return std::any_of(states_.begin(), states_.end(), [](const auto& entry) { return entry.second.name != "ready"; });
}

ProgramState MenuPrograms::state(const std::string& chapter) const {
    const auto found = states_.find(chapter);
    return found == states_.end() ? ProgramState() : found->second;
}

void MenuPrograms::want(const std::string& chapter) {
    wanted_ = chapter;
    const std::filesystem::path beside = folder_ / "wanted.new";
    std::ofstream(beside) << chapter << '\n';
    std::error_code ignored;
    std::filesystem::rename(beside, folder_ / "wanted", ignored);
}

}  // namespace lightwalk
