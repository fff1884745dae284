#include "common/app/foreign_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/scene/import.h"

namespace lightwalk {

ForeignScene::ForeignScene(std::filesystem::path file, const SceneFile& scene, std::string reader, std::string words)
    : file_(std::move(file)), from_(scene.knobs_of == reader ? "" : scene.knobs_of), words_(std::move(words)) {}

void ForeignScene::set_knobs(const SceneFile& scene, const FindKnob& find) {
    for (const auto& [name, value] : scene.knobs) {
        bool may_lack = !from_.empty();
        try {
            KnobBase& knob = find(name);
            may_lack &= name.find('.') == std::string::npos;
            if (!knob.pinned) knob.set(value);
        } catch (const InputError& e) {
            if (!may_lack) throw InputError("{}: key 'knobs': {}", file_.string(), e.what());
            left_out_.insert(name.substr(0, name.find('.')));
        }
    }
}

Model ForeignScene::model(const Module& reader, const std::filesystem::path& file, const std::function<Model()>& load) {
    Model own;
    if (reader.any_proxy(file, own)) return own;
    if (from_.empty() || is_model_file(file)) return load();
    left_out_.insert(file.filename().string());
    own.materials.emplace_back();
    return own;
}

std::string ForeignScene::left_out() const { return fmt::format("{}", fmt::join(left_out_, ", ")); }

void ForeignScene::name_left_out() const {
    if (left_out_.empty()) return;
    warn_once(fmt::format("{}: {} lacks {} of chapter {}; left out", file_.string(), words_, left_out(), from_));
}

}  // namespace lightwalk
