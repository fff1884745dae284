#include "common/gpu/capture.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "common/base/error.h"
#if __has_include(<renderdoc_app.h>)
#include <renderdoc_app.h>
#define LIGHTWALK_HAS_RENDERDOC 1
#endif

namespace lightwalk {
namespace {

constexpr const char* library = "librenderdoc.so";

#ifdef LIGHTWALK_HAS_RENDERDOC
// RTLD_NOLOAD: finds the library without loading it.
RENDERDOC_API_1_1_2* interface() {
    static RENDERDOC_API_1_1_2* found = nullptr;
    if (found) return found;
    void* loaded = dlopen(library, RTLD_NOW | RTLD_NOLOAD);
    const auto get = loaded ? reinterpret_cast<pRENDERDOC_GetAPI>(dlsym(loaded, "RENDERDOC_GetAPI")) : nullptr;
    void* made = nullptr;
    if (!get || get(eRENDERDOC_API_Version_1_1_2, &made) != 1) return nullptr;
    found = static_cast<RENDERDOC_API_1_1_2*>(made);
    // F12 is the course's screenshot key; the overlay would appear in pictures.
    found->SetCaptureKeys(nullptr, 0);
    found->MaskOverlayBits(eRENDERDOC_Overlay_None, eRENDERDOC_Overlay_None);
    found->SetCaptureOptionU32(eRENDERDOC_Option_RefAllResources, 1);
    return found;
}
#endif

}  // namespace

#ifdef LIGHTWALK_HAS_RENDERDOC
void load_renderdoc() {
    setenv("ENABLE_VULKAN_RENDERDOC_CAPTURE", "1", 1);  // enables RenderDoc's implicit layer
    if (!dlopen(library, RTLD_NOW)) throw InputError("a capture needs RenderDoc: apt install renderdoc");
    if (!interface()) throw Failure("RenderDoc's library has no interface of version 1.1.2");
}

bool has_renderdoc() { return interface() != nullptr; }

Capture::Capture() {
    if (!interface()) throw InputError("RenderDoc is not loaded");
    interface()->StartFrameCapture(nullptr, nullptr);
}

Capture::~Capture() {
    if (!ended_ && interface()->IsFrameCapturing()) interface()->EndFrameCapture(nullptr, nullptr);
}

void Capture::write(const std::string& file) {
    namespace fs = std::filesystem;
    ended_ = true;
    const uint32_t before = interface()->GetNumCaptures();
    const std::string stem = file + "." + std::to_string(getpid());
    interface()->SetCaptureFilePathTemplate(stem.c_str());
    const bool made = interface()->EndFrameCapture(nullptr, nullptr) == 1;
    uint32_t length = 0;
    if (!made || interface()->GetNumCaptures() <= before || !interface()->GetCapture(before, nullptr, &length, nullptr))
        throw Failure("RenderDoc made no capture");
    std::string written(length, '\0');
    interface()->GetCapture(before, written.data(), &length, nullptr);
    written.resize(written.find('\0') == std::string::npos ? written.size() : written.find('\0'));
    std::error_code error;
    fs::rename(written, file, error);
    if (error) throw InputError("{} cannot be written: {}", file, error.message());
}
#else
void load_renderdoc() {
    throw InputError(
        "the course was built without RenderDoc's header: apt install librenderdoc-dev renderdoc, build again");
}

bool has_renderdoc() { return false; }

Capture::Capture() { load_renderdoc(); }
Capture::~Capture() = default;
void Capture::write(const std::string&) {}
#endif

}  // namespace lightwalk
