// Fuzzes the reader of scene files: any bytes are a scene or an InputError. Includes are read from a folder that holds
// none, so that nothing but the text is tried.
#include "common/base/error.h"
#include "common/scene/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try {
        lightwalk::parse_scene(std::string(reinterpret_cast<const char*>(data), size), "/nonexistent/scene.json");
    } catch (const lightwalk::InputError&) {}
    return 0;
}
