// Fuzzes the reader of scene files: any bytes are a scene or an InputError. Includes are read from an empty folder,
// and paths that lead out of it are skipped, so that only the text is tested.
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/scene/scene_file.h"

namespace {

bool stays_in_its_folder(const std::string& text) {
    const nlohmann::json scene = nlohmann::json::parse(text, nullptr, false);
    if (!scene.is_object() || !scene.contains("include") || !scene["include"].is_array()) return true;
    for (const nlohmann::json& name : scene["include"]) {
        const std::string file = name.is_string() ? name.get<std::string>() : "";
        if (file.starts_with('/') || file.find("..") != file.npos) return false;
    }
    return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    if (!stays_in_its_folder(text)) return 0;
    try {
        lightwalk::parse_scene(text, "/nonexistent/scene.json");
    } catch (const lightwalk::InputError&) {}
    return 0;
}
