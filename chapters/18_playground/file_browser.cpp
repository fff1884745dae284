#include "18_playground/file_browser.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "18_playground/commands.h"
#include "18_playground/editor_window.h"
#include "18_playground/widgets.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/names.h"
#include "common/base/own_files.h"
#include "common/scene/import.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

fs::path recent_list() {
    const fs::path folder = state_folder();
    return folder.empty() ? folder : folder / "recent_files";
}

const char* image_folder(const std::string& what) {
    return what == "environment" ? "environments" : what == "terrain" ? "terrain" : "textures";
}

}  // namespace

bool can_be_opened(const fs::path& file) {
    return is_model_file(file) || lowercase(file.extension().string()) == ".json";
}

Listing list_folder(const fs::path& folder, const std::string& filter) {
    Listing listing{folder, {}, ""};
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code one;  // of a link that leads nowhere: it is left out
        const bool is_folder = entry->is_directory(one);
        const fs::path name = entry->path().filename();
        if (one || name.string().starts_with('.')) continue;
        if (!is_folder &&
            (!entry->is_regular_file(one) || !(can_be_opened(name) || is_image(name) || is_height_map_file(name)) ||
             !has_words(name.string(), filter)))
            continue;
        listing.files.push_back({entry->path(), is_folder, lowercase(name.extension().string()) == ".json",
                                 is_folder ? 0 : entry->file_size(one)});
    }
    if (error) listing.error = folder.string() + ": " + error.message();
    std::ranges::sort(listing.files, {}, [](const Listing::File& file) {
        return std::pair(!file.is_folder, lowercase(file.path.filename().string()));
    });
    return listing;
}

std::vector<fs::path> recent_files() {
    std::vector<fs::path> files;
    try {
        std::istringstream lines(read_file(recent_list(), 1 << 16));
        for (std::string line; std::getline(lines, line) && files.size() < 10;)
            if (file_exists(line)) files.emplace_back(line);
    } catch (const InputError&) {}  // there is none yet
    return files;
}

void remember_file(const fs::path& file) {
    const fs::path list = recent_list(), own = fs::absolute(file);
    if (list.empty() || own.string().find('\n') != std::string::npos) return;
    std::string text = own.string() + "\n";
    int count = 1;
    for (const fs::path& one : recent_files())
        if (one != own && count++ < 10) text += one.string() + "\n";
    std::error_code error;
    fs::create_directories(list.parent_path(), error);
    try {
        write_file(list, text);
    } catch (const InputError&) {}  // a home that cannot be written
}

void FileBrowser::go(const fs::path& folder) {
    thumbnails.leave();
    listing_ = list_folder(folder, filter_);
    typed_ = folder.string();
    marked_ = 0;
}

void FileBrowser::pick_image(const std::string& what, const Take& take) {
    image_for_ = what;
    take_image_ = take;
    shown = true;
    const fs::path assets = course_root() / "assets";
    if (listing_.folder.empty() || lies_below(listing_.folder, assets)) listing_.folder = assets / image_folder(what);
    drawn_in_ = -1;  // its folder is read again
}

std::optional<fs::path> FileBrowser::dropped() const {
    const ImGuiPayload* const dragged = ImGui::GetDragDropPayload();
    if (!dragged || !dragged->IsDataType("file") || !ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return std::nullopt;
    return fs::path(std::string(static_cast<const char*>(dragged->Data), static_cast<size_t>(dragged->DataSize)));
}

// Thumbnail, name and size; true: it was clicked.
bool FileBrowser::draw_file(const Listing::File& file, bool marked, float scale) {
    const std::string name = clean_name(file.path.filename().string());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight(), height = std::max(scale * float(Thumbnails::size.y), 2.0f * line);
    const float left = scale * (float(Thumbnails::size.x) + 8.0f);
    const bool clicked = ImGui::Selectable("##file", marked, 0, {0.0f, height});
    log_place("file." + name);
    help_on_hover(name.c_str());
    if (!file.is_folder && ImGui::BeginDragDropSource()) {
        const std::string path = file.path.string();
        ImGui::SetDragDropPayload("file", path.data(), path.size());
        ImGui::TextUnformatted(name.c_str());
        ImGui::EndDragDropSource();
    }
    if (const Image8* picture = file.is_folder ? nullptr : thumbnails.of(file.path)) {
        draw_pixels(*picture, corner, scale);
        log_place("thumbnail." + name);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float text = file.is_folder ? corner.y + 0.5f * (height - line) : corner.y;
    list.AddText({corner.x + left, text}, ImGui::GetColorU32(ImGuiCol_Text),
                 (file.is_folder ? name + "/" : name).c_str());
    const double kilobytes = double(file.bytes) / 1e3;
    const std::string size =
        kilobytes < 1e3 ? fmt::format("{:.0f} KB", std::ceil(kilobytes)) : fmt::format("{:.1f} MB", kilobytes / 1e3);
    if (!file.is_folder) list.AddText({corner.x + left, text + line}, ImGui::GetColorU32(quiet_color), size.c_str());
    return clicked;
}

void FileBrowser::draw(float scale) {
    const int frame = ImGui::GetFrameCount();
    if (std::exchange(drawn_in_, frame) != frame - 1) {  // it was closed
        filter_.clear();
        if (listing_.folder.empty()) listing_.folder = course_root() / "assets" / "models";
        go(listing_.folder);
        recent_ = recent_files();
    }
    if (take_image_) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(reference_color, "choose: %s", image_for_.c_str());
        ImGui::SameLine();
        if (tool_button("none of them", "Esc: it stays as it was")) close();
    }
    ImGui::SetNextItemWidth(-1.0f);
    std::optional<fs::path> take, enter;
    if (text_field("##path", typed_, "path of a file or folder")) {
        const fs::path typed = typed_;
        if (std::error_code error; fs::is_directory(typed, error))
            enter = typed;
        else
            take = typed;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {5.0f * scale, 3.0f * scale});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {5.0f * scale, 5.0f * scale});
    const auto place = tool_row({{"up", "up", "The folder above (Backspace)"},
                                 {"here", "here", "The current folder"},
                                 {"scenes", "scenes", "The course's scenes"}});
    const auto kind = tool_row({{"models", "models", "The course's models"},
                                {"images", "images", "The course's textures"},
                                {"environments", "environments", "Images for light from all around"}});
    std::error_code gone;
    const fs::path assets = course_root() / "assets";
    if (place == 0) enter = listing_.folder.parent_path();
    if (place == 1) enter = fs::current_path(gone);
    if (place == 2) enter = assets / "scenes";
    if (kind == 0) enter = assets / "models";
    if (kind == 1) enter = assets / "textures";
    if (kind == 2) enter = assets / "environments";
    ImGui::PopStyleVar(2);
    if (!take_image_) {
        ImGui::Checkbox("add to the scene", &adds_);
        log_place("tool.adds");
        help_on_hover("On: a model is added to this scene. Off: the file is opened in its place.");
    }
    ImGui::SetNextItemWidth(-1.0f);
    if (text_field("##file filter", filter_, "filter by name", true)) go(listing_.folder);
    help_on_hover("Filter: words that must be in the name");
    if (!listing_.error.empty()) ImGui::TextColored(error_color, "%s", listing_.error.c_str());
    const int count = static_cast<int>(listing_.files.size());
    if (ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) && !ImGui::GetIO().WantTextInput) {
        if (key_pressed(ImGuiKey_DownArrow)) marked_ = std::min(marked_ + 1, count - 1);
        if (key_pressed(ImGuiKey_UpArrow)) marked_ = std::max(marked_ - 1, 0);
        if (key_pressed(ImGuiKey_Backspace)) enter = listing_.folder.parent_path();
        if (key_pressed(ImGuiKey_Enter) && marked_ < count) {
            const Listing::File& file = listing_.files[static_cast<size_t>(marked_)];
            (file.is_folder ? enter : take) = file.path;
        }
    }
    ImGui::BeginChild("list", {0.0f, recent_.empty() ? 0.0f : -90.0f * scale});
    ImGuiListClipper clipper;
    clipper.Begin(count);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Listing::File& file = listing_.files[static_cast<size_t>(i)];
            ImGui::PushID(i);
            if (draw_file(file, i == marked_, scale)) {
                marked_ = i;
                (file.is_folder ? enter : take) = file.path;
            }
            ImGui::PopID();
        }
    ImGui::EndChild();
    if (!recent_.empty()) ImGui::TextColored(quiet_color, "opened last");
    const float right = ImGui::GetWindowContentRegionMax().x, gap = ImGui::GetStyle().ItemSpacing.x;
    float used = right;  // of this line
    for (const fs::path& file : recent_) {
        const std::string name = clean_name(file.filename().string()), whole = clean_name(file.string());
        const float width = ImGui::CalcTextSize(name.c_str()).x;
        if (used + gap + width < right) {
            ImGui::SameLine(0.0f, gap);
            used += gap + width;
        } else
            used = ImGui::GetCursorPosX() + width;
        ImGui::PushID(whole.c_str());
        if (ImGui::Selectable(name.c_str(), false, 0, {width, 0.0f})) take = file;
        ImGui::PopID();
        log_place("recent." + name);
        help_on_hover(whole.c_str());
    }
    if (enter) go(*enter);
    if (take) {
        const Take take_image = take_image_;
        close();
        if (take_image)
            take_image(*take);
        else if (chosen)
            chosen(*take, adds_ && lowercase(take->extension().string()) != ".json");
    }
}

void pick_button(EditorView& view, const std::string& what, const std::function<void(const std::string&)>& take) {
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::PushID(what.c_str());
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0.0f, ImGui::GetStyle().FramePadding.y});
    const bool clicked = ImGui::Button(icon_or(icon::folder, "..."), {ImGui::GetFrameHeight(), 0.0f});
    ImGui::PopStyleVar();
    ImGui::PopID();
    log_place("pick." + what);
    help_on_hover("Choose a file");
    if (clicked) view.pick(what, [take](const fs::path& file) { take(asset_name(file).string()); });
}

}  // namespace lightwalk
