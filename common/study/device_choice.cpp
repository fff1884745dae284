#include "common/study/device_choice.h"

#include <algorithm>
#include <utility>

#include "common/app/render.h"
#include "common/base/exercise.h"
#include "common/base/kept.h"
#include "common/base/text.h"
#include "common/study/gpu_time.h"

namespace lightwalk {
namespace {

constexpr double clearly_less = 0.9;  // of two runs' times
constexpr size_t longest_entry = 4096;

// Values that draw one picture, the default first; none where no device's choice is wanted.
std::vector<std::string> ways_of(const Choice& knob) {
    if (knob.name == "shaded") return knob.options;
    // Light volumes, or a dispatch over tiles: one G-buffer.
    if (knob.path() == "gbuffer.method" && knob.is("packed")) return {"packed", "tiled"};
    return {};
}

DeviceChoice measured(Choice& knob, const std::vector<std::string>& ways, const std::function<double()>& measure) {
    DeviceChoice choice{.knob = knob.path(), .value = ways.front(), .line = ""};
    double first_ms = 0, least_ms = 0;
    for (const std::string& option : ways) {
        knob.set(option);
        const double ms = measure();
        choice.line += fmt::format("{}{} {:.2f} ms", choice.line.empty() ? "" : ", ", option, ms);
        if (option == ways.front()) first_ms = least_ms = ms;
        if (ms < std::min(least_ms, clearly_less * first_ms)) {
            least_ms = ms;
            choice.value = option;
        }
    }
    return choice;
}

// "visibility: raster 18.80 ms, visibility 1.70 ms"
std::optional<DeviceChoice> kept_choice(const Choice& knob, const std::filesystem::path& file) {
    const std::string entry = read_kept(file, longest_entry).value_or("");
    const size_t end = entry.find(": ");
    if (end == entry.npos) return {};
    DeviceChoice choice{knob.path(), entry.substr(0, end), entry.substr(end + 2)};
    const bool known = std::find(knob.options.begin(), knob.options.end(), choice.value) != knob.options.end();
    return known ? std::optional(choice) : std::nullopt;
}

}  // namespace

std::vector<DeviceChoice> choose_by_device(const KnobList& knobs, const std::string& device,
                                           const std::function<double()>& measure) {
    std::vector<DeviceChoice> all;
    for (KnobBase* const one : knobs) {
        auto* const knob = dynamic_cast<Choice*>(one);
        if (!knob || knob->pinned || knob->changed()) continue;
        const std::vector<std::string> ways = ways_of(*knob);
        if (ways.empty()) continue;
        const auto file = kept_file("choice by device, 1\n" + device + "\n" + knob->path(), ".choice");
        std::optional<DeviceChoice> choice = kept_choice(*knob, file);
        if (!choice) {
            const std::string before = knob->text();
            try {
                choice = measured(*knob, ways, measure);
            } catch (const std::exception&) {  // drawing says so itself
                knob->set(before);
                continue;
            }
            keep(file, choice->value + ": " + choice->line);
        }
        knob->change_default(choice->value);
        all.push_back(std::move(*choice));
    }
    return all;
}

std::vector<DeviceChoice> choose_by_device(Chapter& chapter, Gpu& gpu) {
    const std::vector<std::string> ids = Exercises::ids();
    if (gpu.device.software() || !std::all_of(ids.begin(), ids.end(), Exercises::uses_solution)) return {};
    const std::string device = gpu.device.info.name + "\n" + gpu.device.info.driver + "\n" + chapter.name;
    chapter.tries_knobs = true;
    const auto measure = [&] {
        Frame frame(gpu);
        double least = 1e9;
        for (int i = 0; i < 4; ++i) {  // the first one compiles, and warms up
            render(chapter, frame, {.size = {480, 270}, .gathered = 0});
            least = std::min(least, gpu_ms(frame));
        }
        return least;
    };
    std::vector<DeviceChoice> all = choose_by_device(chapter.all_knobs(), device, measure);
    chapter.tries_knobs = false;
    return all;
}

}  // namespace lightwalk
