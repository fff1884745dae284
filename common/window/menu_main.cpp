// The menu: a picture of each chapter; a click starts it, and its end brings the menu back. A chapter that is not built yet
// shows how far its build is; a click builds it next.
#include <GLFW/glfw3.h>

#include <fstream>
#include <map>

#include "common/app/shots.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/own_files.h"
#include "common/base/text.h"
#include "common/gpu/frame.h"
#include "common/image/image.h"
#include "common/window/blit.h"
#include "common/window/child_process.h"
#include "common/window/event_log.h"
#include "common/window/exercise_checks.h"
#include "common/window/lesson_pages.h"
#include "common/window/overlay.h"

namespace lightwalk {
namespace {

namespace fs = std::filesystem;

/// A chapter's program: whether it can be started, and how far its build is.
struct ProgramState {
    std::string name = "ready";  ///< or waiting, building, failed
    int done = 0, total = 0;     ///< steps of a chapter that is being built
    bool operator==(const ProgramState&) const = default;
};

class MenuPrograms {
  public:
    /// A folder through which the build and the menu talk; "": all chapters are built.
    explicit MenuPrograms(fs::path folder) : folder_(std::move(folder)) { poll(); }

    /// Reads the states again. True if one has changed.
    bool poll() {
        if (folder_.empty()) return false;
        std::ifstream file(folder_ / "states");
        std::map<std::string, ProgramState> states;
        std::string chapter;
        for (ProgramState state; file >> chapter >> state.name >> state.done >> state.total;) states[chapter] = state;
        if (states.empty() || states == states_) return false;
        states_ = std::move(states);
        return true;
    }

    /// Whether some chapter is not ready.
    bool are_building() const {
        return std::any_of(states_.begin(), states_.end(),
                           [](const auto& entry) { return entry.second.name != "ready"; });
    }

    const std::map<std::string, ProgramState>& states() const { return states_; }
    ProgramState state(const std::string& chapter) const {
        const auto found = states_.find(chapter);
        return found == states_.end() ? ProgramState() : found->second;
    }

    /// Asks for a chapter to be built before the others.
    void want(const std::string& chapter) {
        wanted_ = chapter;
        const fs::path beside = folder_ / "wanted.new";
        std::ofstream(beside) << chapter << '\n';
        std::error_code ignored;
        fs::rename(beside, folder_ / "wanted", ignored);
    }
    const std::string& wanted() const { return wanted_; }

  private:
    fs::path folder_;
    std::map<std::string, ProgramState> states_;
    std::string wanted_;
};

struct MenuEntry {
    std::string chapter, title;
    fs::path program;
    Image picture;  ///< none if nothing has been drawn yet
};

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

// The chapter that a menu started last; "": none, or no home folder to remember it in.
std::string read_last_started() {
    std::string chapter;
    if (const fs::path folder = state_folder(); !folder.empty()) std::ifstream(folder / "menu.last") >> chapter;
    return chapter;
}

void write_last_started(const std::string& chapter) {
    const fs::path folder = state_folder();
    std::error_code error;
    if (folder.empty() || (fs::create_directories(folder, error), error)) return;
    std::ofstream(folder / "menu.last") << chapter << '\n';
}

// Chapters that are built or being built beside this program, in order. `scale`: of the display.
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
            const Image8 picture = thumbnail(to_linear(read_image8(*file)), size);
            entry.picture =
                Image(gpu.device, {.name = entry.chapter, .format = VK_FORMAT_R8G8B8A8_UNORM, .size = size});
            gpu.upload(entry.picture, std::as_bytes(std::span(picture.pixels)));
        }
    return entries;
}

constexpr float least_width = 295.0f, most_width = 470.0f;  ///< of a tile, at scale 1

class Menu {
  public:
    Menu(Gpu& gpu, Display& display, const std::string& programs, std::vector<std::string> options)
        : gpu_(gpu),
          display_(display),
          options_(std::move(options)),
          swapchain_(gpu, display),
          overlay_(gpu, display, swapchain_),
          screen_(gpu),
          programs_(programs),
          entries_(find_chapters(gpu, display.scale(), programs_)) {
        enable_keyboard();
    }

    void run() {
        int settle = 3;  // pictures to draw until the widgets have come to rest
        while (!display_.wants_to_close()) {
            const Input input = display_.poll(settle > 0 ? 0.0 : programs_.are_building() ? 0.2 : 0.5);
            if (programs_.poll()) settle = 3;
            for (const KeyPress& press : input.pressed)
                if (press.key == GLFW_KEY_ESCAPE) return;
            if (input.happened) settle = 3;
            if (!swapchain_.ready()) {
                display_.poll(0.2);
                continue;
            }
            if (const std::string wrong = lessons_.poll(); !wrong.empty()) {
                message_ = wrong;
                settle = 3;
            }
            if (settle-- <= 0) continue;
            if (const MenuEntry* chosen = draw()) {
                choose(*chosen);
                settle = 3;
            }
        }
    }

  private:
    /// The chapter that was clicked, or null.
    const MenuEntry* draw() {
        overlay_.begin();
        const MenuEntry* chosen = build();
        overlay_.end();
        const Image* target = swapchain_.acquire();
        if (!target) return chosen;
        screen_.begin({1, 1}, 0.0f);
        screen_.transfer("clear", {.reads = {}, .writes = {*target}}, [&](VkCommandBuffer commands) {
            const VkClearColorValue ground{.float32 = {0.085f, 0.095f, 0.115f, 1.0f}};
            const VkImageSubresourceRange range = target->range();
            vkCmdClearColorImage(commands, target->handle, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &ground, 1, &range);
        });
        std::vector<Resource> pictures;
        for (const Tile& tile : tiles_) pictures.push_back(tile.entry->picture);
        screen_.transfer("pictures", {.reads = pictures, .writes = {*target}}, [&](VkCommandBuffer commands) {
            for (const Tile& tile : tiles_) blit_clipped(commands, tile, *target);
        });
        screen_.transfer("labels", {}, [&](VkCommandBuffer commands) { overlay_.draw(commands); });
        screen_.end(swapchain_.acquired(), swapchain_.rendered());
        swapchain_.present();
        if (++drawn_ == 1) log_event("first picture");
        return chosen;
    }

    const MenuEntry* build() {
        const MenuEntry* chosen = nullptr;
        tiles_.clear();
        const ImGuiIO& io = ImGui::GetIO();
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize(io.DisplaySize);
        ImGui::Begin("menu", nullptr,
                     (ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings);
        ImGui::PushFont(overlay_.large);
        ImGui::TextUnformatted("Lightwalk");
        ImGui::PopFont();
        ImGui::TextColored(quiet_color, "%s", what_to_do().c_str());
        if (!message_.empty()) ImGui::TextColored(mine_color, "%s", message_.c_str());
        const float scale = display_.scale(), gap = 16.0f * scale;
        // With or without a scrollbar tiles are as wide: else one could come and go.
        const ImGuiStyle& style = ImGui::GetStyle();
        const float across = io.DisplaySize.x - 2.0f * style.WindowPadding.x - style.ScrollbarSize;
        const auto size_in = [&](int columns) {
            const float width = std::floor((across + gap) / static_cast<float>(columns) - gap);
            return ImVec2{width, std::floor(width * 9.0f / 16.0f) + 34.0f * scale};
        };
        // Larger ones as long as all of them are in sight.
        const auto fit = [&](int columns) {
            const int rows = (static_cast<int>(entries_.size()) + columns - 1) / columns;
            return size_in(columns).x <= most_width * scale &&
                   static_cast<float>(rows) * (size_in(columns).y + gap) < ImGui::GetContentRegionAvail().y;
        };
        int columns = std::max(1, static_cast<int>((across + gap) / (least_width * scale + gap)));
        while (columns > 1 && fit(columns - 1)) --columns;
        const ImVec2 size = size_in(columns);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
        for (size_t i = 0; i < entries_.size(); ++i) {
            if (i % static_cast<size_t>(columns) != 0) ImGui::SameLine();
            if (tile(entries_[i], size)) chosen = &entries_[i];
        }
        ImGui::PopStyleVar();
        if (entries_.empty()) ImGui::TextUnformatted("No chapter is built yet.");
        ImGui::End();
        return chosen;
    }

    bool tile(const MenuEntry& entry, ImVec2 size) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float foot = size.y - 34.0f * display_.scale();
        ImGui::BeginGroup();
        const bool clicked = button_under_others(entry.chapter.c_str(), size);  // the link to the lesson
        log_place("chapter." + entry.chapter);
        const bool goes_on = entry.chapter == last_started_ && programs_.state(entry.chapter).name == "ready";
        if (goes_on) ImGui::SetItemDefaultFocus();  // arrow keys begin here
        const bool hovered = ImGui::IsItemHovered();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 end{corner.x + size.x, corner.y + size.y};
        list.AddRectFilled({corner.x, corner.y + foot}, end,
                           ImGui::GetColorU32(hovered ? ImGuiCol_ButtonActive : ImGuiCol_Button));
        const std::string number = entry.chapter.substr(0, 2);
        const ImVec2 text{corner.x + 10.0f, corner.y + foot + 8.0f * display_.scale()};
        list.AddText(text, ImGui::GetColorU32(mine_color), number.c_str());
        list.AddText({text.x + 30.0f * display_.scale(), text.y}, ImGui::GetColorU32(ImGuiCol_Text),
                     entry.title.c_str());
        if (const Solved of = solved_of(entry.chapter); of.solved > 0) {
            const std::string words = std::to_string(of.solved) + " of " + std::to_string(of.exercises) + " solved";
            list.AddText({end.x - ImGui::CalcTextSize(words.c_str()).x - 10.0f, text.y},
                         ImGui::GetColorU32(right_color), words.c_str());
            log_place("solved." + entry.chapter);
        }
        if (entry.picture) {
            tiles_.push_back({&entry, {corner.x, corner.y}, {size.x, foot}});
        } else {
            list.AddRectFilled(corner, {end.x, corner.y + foot}, ImGui::GetColorU32({0.12f, 0.13f, 0.155f, 1.0f}));
            list.AddText({corner.x + 10.0f, corner.y + 10.0f}, ImGui::GetColorU32(quiet_color), "no picture yet");
        }
        if (goes_on) {
            const ImVec2 words = ImGui::CalcTextSize("go on"), low{corner.x, corner.y + foot - words.y - 10.0f};
            list.AddRectFilled(low, {low.x + words.x + 20.0f, corner.y + foot}, IM_COL32(16, 18, 22, 225));
            list.AddText({low.x + 10.0f, low.y + 5.0f}, ImGui::GetColorU32(mine_color), "go on");
            log_place("go_on." + entry.chapter);
        }
        draw_state(entry, corner, {end.x, corner.y + foot});
        if (hovered) list.AddRect(corner, end, ImGui::GetColorU32(reference_color), 0.0f, 0, 2.0f);
        const float width = ImGui::CalcTextSize("lesson").x + 2.0f * ImGui::GetStyle().FramePadding.x;
        ImGui::SetCursorScreenPos({end.x - width - 8.0f, corner.y + 8.0f});
        if (ImGui::SmallButton(("lesson##" + entry.chapter).c_str())) message_ = lessons_.open(entry.chapter);
        log_place("lesson." + entry.chapter);
        ImGui::EndGroup();
        return clicked;
    }

    std::string what_to_do() const {
        if (!programs_.are_building())
            return "Click a chapter to start it, or press Space where the arrow keys lead; Esc in it comes back here.";
        size_t ready = 0;
        for (const MenuEntry& entry : entries_) ready += programs_.state(entry.chapter).name == "ready";
        return std::to_string(ready) + " of " + std::to_string(entries_.size()) +
               " chapters are built. Click one to start it, or to build it next.";
    }

    /// Over a chapter's picture while it cannot be started: its status, and a bar.
    void draw_state(const MenuEntry& entry, ImVec2 corner, ImVec2 end) {
        const ProgramState state = programs_.state(entry.chapter);
        if (state.name == "ready") return;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const float scale = display_.scale(), top = end.y - 30.0f * scale;
        list.AddRectFilled(corner, end, IM_COL32(16, 18, 22, 120));
        list.AddRectFilled({corner.x, top}, end, IM_COL32(16, 18, 22, 225));
        std::string words = entry.chapter == programs_.wanted() ? "next" : "not built yet";
        if (state.name == "failed") words = "does not compile: the terminal says why";
        if (state.name == "building" && state.total == 0) words = "compiling";
        if (state.name == "building" && state.total > 0) {
            words = "compiling, " + std::to_string(state.done) + " of " + std::to_string(state.total);
            const float width = (end.x - corner.x) * float(state.done) / float(state.total);
            list.AddRectFilled({corner.x, end.y - 5.0f * scale}, {corner.x + width, end.y},
                               ImGui::GetColorU32(right_color));
        }
        list.AddText({corner.x + 10.0f * scale, top + 4.0f * scale}, ImGui::GetColorU32(ImGuiCol_Text), words.c_str());
    }

    void choose(const MenuEntry& entry) {
        if (programs_.state(entry.chapter).name == "ready") return start(entry);
        programs_.want(entry.chapter);
        log_event("wanted " + entry.chapter);
    }

    struct Tile {
        const MenuEntry* entry;
        glm::vec2 corner, size;  ///< of its picture, pixels; outside the window where it is scrolled away
    };

    static void blit_clipped(VkCommandBuffer commands, const Tile& tile, const Image& target) {
        const Image& picture = tile.entry->picture;
        const glm::ivec2 corner(tile.corner), size(tile.size), window(target.desc.size);
        const glm::ivec2 begin = glm::clamp(corner, glm::ivec2(0), window);
        const glm::ivec2 end = glm::clamp(corner + size, begin, window);
        const glm::vec2 texels = glm::vec2(picture.desc.size) / tile.size;
        const glm::uvec2 from(glm::vec2(begin - corner) * texels), to(glm::vec2(end - corner) * texels);
        blit(commands, picture, {from, to - from}, target, {glm::uvec2(begin), glm::uvec2(end - begin)});
    }

    void start(const MenuEntry& entry) {
        message_.clear();
        try {
            ChildProcess child(entry.program, options_);
            log_event("started " + entry.chapter);
            write_last_started(last_started_ = entry.chapter);
            glfwHideWindow(display_.window);
            std::optional<int> code;
            while (!(code = child.poll())) display_.poll(0.1);
            log_event(entry.chapter + " ended with " + std::to_string(*code));
            if (*code != 0)
                message_ = entry.chapter + " ended with code " + std::to_string(*code) + ": " + child.last_words();
        } catch (const Failure& e) { message_ = e.what(); }
        glfwShowWindow(display_.window);
    }

    Gpu& gpu_;
    Display& display_;
    std::vector<std::string> options_;
    Swapchain swapchain_;
    Overlay overlay_;
    Frame screen_;
    MenuPrograms programs_;
    std::vector<MenuEntry> entries_;
    std::vector<Tile> tiles_;
    LessonPages lessons_;
    std::string message_, last_started_ = read_last_started();
    int drawn_ = 0;
};

int run_menu(std::vector<std::string> options) {
    std::string programs;
    if (options.size() > 1 && options[0] == "--programs") {
        programs = options[1];
        options.erase(options.begin(), options.begin() + 2);
    }
    const auto value_of = [&](const char* name) {
        for (size_t i = 0; i + 1 < options.size(); ++i)
            if (options[i] == name) return options[i + 1];
        return std::string();
    };
    log_events(value_of("--events") == "on");
    Display display("Lightwalk", {.scaled = {1040, 720}}, "./course run --gallery");
    Gpu gpu({.name = value_of("--device"),
             .validate = value_of("--validate") == "on",
             .surface_extensions = Display::surface_extensions(),
             .presents = [&display](VkInstance instance, VkPhysicalDevice physical, uint32_t queue_family) {
                 return display.takes(instance, physical, queue_family);
             }});
    Menu(gpu, display, programs, options).run();
    gpu.device.check_validation();
    return 0;
}

}  // namespace
}  // namespace lightwalk

/// --programs FOLDER comes first (MenuPrograms). All other options are passed on to the chapters; --device, --validate and
/// --events are the menu's own too.
int main(int argc, char** argv) {
    try {
        return lightwalk::run_menu({argv + 1, argv + argc});
    } catch (const std::exception& e) { return lightwalk::report_exception(e); }
}
