#include "common/window/knob_sections.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/names.h"
#include "common/base/own_files.h"
#include "common/window/event_log.h"
#include "common/window/knob_widgets.h"
#include "common/window/overlay.h"

namespace lightwalk {

namespace {

// Over the header drawn last, at its right end.
void write_at_right(const std::string& text) {
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    ImGui::GetWindowDrawList()->AddText(
        {to.x - size.x - ImGui::GetStyle().FramePadding.x, from.y + 0.5f * (to.y - from.y - size.y)},
        ImGui::GetColorU32(quiet_color), text.c_str());
}

std::string cost_of_knob(const KnobBase& knob, const std::vector<PassTime>& times) {
    for (const PassTime& time : times)
        if (time.name == knob.path()) return fmt::format("{:.2f} ms", time.gpu_ms);
    return {};
}

// The chapter's own subject: its knobs, and the module with the method that --method sets.
bool is_own(const std::string& path, const KnobList& knobs) {
    return path.empty() ||
           std::any_of(knobs.begin(), knobs.end(), [](const KnobBase* knob) { return knob->preferred; });
}

}  // namespace

double module_ms(std::string_view module, const std::vector<PassTime>& times) {
    double sum = 0;
    for (const PassTime& time : times) {
        const std::string_view name = time.name;
        const bool begins = name.substr(0, module.size()) == module;
        const bool ends = name.size() >= module.size() && name.substr(name.size() - module.size()) == module;
        if (begins || ends) sum += time.gpu_ms;
    }
    return sum;
}

KnobSections::KnobSections(std::string chapter) : chapter_(std::move(chapter)), open_(read_panel_memory(chapter_)) {}

void KnobSections::remember(const std::string& path, bool open) {
    open_[path] = open;
    write_panel_memory(chapter_, open_);
    log_event(fmt::format("section {} {}", path.empty() ? "chapter" : path, open ? "open" : "closed"));
}

bool KnobSections::section(const std::string& path, const KnobList& knobs, const std::vector<PassTime>& times,
                           AutoChoices& automatic) {
    const bool filtered = filter_[0] != 0;
    const std::string title = path.empty() ? "this chapter" : path;
    const auto stored = open_.find(path);
    const bool was_open = stored != open_.end() ? stored->second : is_own(path, knobs);
    ImGui::SetNextItemOpen(filtered || was_open);
    const bool open = ImGui::CollapsingHeader(title.c_str());
    if (!filtered && open != was_open) remember(path, open);
    const auto changed_count =
        std::count_if(knobs.begin(), knobs.end(), [](const auto* knob) { return knob->changed(); });
    const double ms = path.empty() ? 0.0 : module_ms(path.substr(path.rfind('.') + 1), times);
    std::string beside = changed_count ? fmt::format("{} changed", changed_count) : "";
    if (ms > 0) beside += fmt::format("{}{:.2f} ms", beside.empty() ? "" : "   ", ms);
    write_at_right(beside);
    log_place("knobs." + (path.empty() ? "chapter" : path));
    if (!open) return false;
    ImGui::PushID(path.c_str());
    bool changed = false;
    const float label_width = label_column(knobs);
    for (KnobBase* knob : knobs)
        if (knob_widget(*knob, label_width, cost_of_knob(*knob, times), &automatic)) {
            changed = true;
            log_event("knob " + knob->path() + " " + knob->text());
        }
    if (changed_count) {
        if (ImGui::Button("reset this section", {-1.0f, 0.0f})) {
            for (KnobBase* knob : knobs) knob->reset();
            changed = true;
            log_event("reset " + title);
        }
        log_place("reset." + (path.empty() ? "chapter" : path));
    }
    ImGui::PopID();
    return changed;
}

bool KnobSections::draw(Chapter& chapter, const std::vector<PassTime>& times, AutoChoices& automatic) {
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::InputTextWithHint("##filter", "filter by name or help", filter_, sizeof filter_);
    log_place("filter");
    std::vector<std::pair<std::string, KnobList>> sections{{"", {}}};
    for (KnobBase* knob : chapter.all_knobs()) {
        const std::string path = knob->owner.path();
        auto at = std::find_if(sections.begin(), sections.end(), [&](const auto& one) { return one.first == path; });
        if (at == sections.end()) at = sections.insert(at, {path, {}});
        if (has_words(knob->path() + " " + knob->help, filter_)) at->second.push_back(knob);
    }
    bool changed = false, any = false;
    for (const auto& [path, knobs] : sections)
        if (!knobs.empty()) {
            any = true;
            changed |= section(path, knobs, times, automatic);
        }
    if (!any) ImGui::TextColored(quiet_color, "no knob matches");
    return changed;
}

namespace {

namespace fs = std::filesystem;

constexpr size_t most_bytes = 1 << 16;

// Empty if there is no home.
fs::path memory_file(const std::string& chapter) {
    const fs::path folder = state_folder();
    return folder.empty() ? folder : folder / (chapter + ".panel.json");
}

}  // namespace

std::map<std::string, bool> read_panel_memory(const std::string& chapter) {
    const fs::path file = memory_file(chapter);
    if (file.empty() || !file_exists(file)) return {};
    try {
        const auto json = nlohmann::json::parse(read_file(file, most_bytes), nullptr, false);
        std::map<std::string, bool> open;
        if (json.is_object())
            for (const auto& [name, value] : json.items())
                if (value.is_boolean()) open[name] = value.get<bool>();
        return open;
    } catch (const InputError&) { return {}; }
}

void write_panel_memory(const std::string& chapter, const std::map<std::string, bool>& open) {
    const fs::path file = memory_file(chapter);
    std::error_code error;
    if (file.empty() || (fs::create_directories(file.parent_path(), error), error)) return;
    try {
        write_file(file, nlohmann::json(open).dump(1) + "\n");
    } catch (const InputError&) {}
}

}  // namespace lightwalk
