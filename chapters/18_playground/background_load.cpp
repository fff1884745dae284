#include "18_playground/background_load.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "01_obj/obj.h"
#include "04_surface_maps/tangents.h"

namespace lightwalk {
namespace {

bool is_ready(const std::future<LoadedModel>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

// [start]
void BackgroundLoad::start(const std::filesystem::path& file) {
    cancel();
    const auto shared = std::make_shared<Progress>();
    now_.emplace(Now{file, shared, std::async(std::launch::async, [file, shared] {
                         progress() = shared.get();
                         LoadedModel read{load_model(file), {}};
                         read.frames = frame_model(read.model);
                         return read;
                     })});
}

void BackgroundLoad::cancel() {
    if (now_) {
        now_->progress->cancelled = true;
        dropped_.push_back(std::move(now_->read));  // a future waits for its thread when it goes
    }
    now_.reset();
    std::erase_if(dropped_, is_ready);
}
// [/start]

std::optional<BackgroundLoad::Ended> BackgroundLoad::poll() {
    if (!now_ || !is_ready(now_->read)) return {};
    Ended ended{now_->file, {}, ""};
    try {
        ended.model = now_->read.get();
    } catch (const std::exception& e) { ended.error = e.what(); }
    now_.reset();
    return ended;
}

float BackgroundLoad::share() const { return now_ ? std::clamp(now_->progress->share(), 0.0f, 1.0f) : 0.0f; }

std::string BackgroundLoad::words() const {
    if (!now_) return "";
    const char* const stage = now_->progress->stage.load();
    return fmt::format("{}: {} {:.0f}%", now_->file.filename().string(), *stage ? stage : "opening", 100.0f * share());
}

}  // namespace lightwalk
