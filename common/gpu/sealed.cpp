#include "common/gpu/sealed.h"

#include <cstring>
#include <filesystem>

#include "common/base/files.h"
#include "common/gpu/glsl.h"

namespace lightwalk {
namespace {

namespace fs = std::filesystem;

fs::path into_folder, from_folder;

}  // namespace

std::string sealed_name(const std::string& shader, const Macros& macros, const std::string& source) {
    std::string key = shader + "\n" + source + "\n";
    for (const auto& [name, value] : macros.values()) key += name + "=" + value + "\n";
    return fmt::format("{:016x}{:016x}.spv", hash_bytes(key), hash_bytes(key, 7));
}

void use_sealed(std::string into, std::string from) {
    into_folder = std::move(into);
    from_folder = std::move(from);
}

bool only_sealed() { return !from_folder.empty(); }

std::vector<uint32_t> read_sealed(const std::string& name) {
    std::error_code error;
    const fs::path file = from_folder / name;
    if (!fs::is_regular_file(file, error)) throw ShaderError("a shader is asked for that the picture does not need");
    const std::string bytes = read_file(file);
    std::vector<uint32_t> spirv(bytes.size() / 4);
    std::memcpy(spirv.data(), bytes.data(), 4 * spirv.size());
    return spirv;
}

void seal(const std::string& name, const std::vector<uint32_t>& spirv) {
    if (!into_folder.empty())
        write_file(into_folder / name, {reinterpret_cast<const char*>(spirv.data()), 4 * spirv.size()});
}

}  // namespace lightwalk
