#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <regex>
#include <spirv-tools/libspirv.hpp>
#include <sstream>

#include "common/base/files.h"
#include "common/gpu/cache_folder.h"
#include "common/gpu/glsl.h"

namespace lightwalk {
namespace fs = std::filesystem;
namespace {

EShLanguage language(Stage stage) {
    switch (stage) {
        case Stage::vertex:
            return EShLangVertex;
        case Stage::geometry:
            return EShLangGeometry;
        case Stage::fragment:
            return EShLangFragment;
        case Stage::compute:
            return EShLangCompute;
    }
    return EShLangVertex;
}

// Line `number` of a shader, for a message about it; nothing where the file is none of the course's shaders: any text
// may say "#line 3" and name any file.
std::string line_of(const std::string& file, int number) {
    const fs::path path = fs::path(file).lexically_normal();
    const std::string room = path.empty() ? "" : path.begin()->string();
    std::error_code error;
    if (path.is_absolute() || (room != "shaders" && room != "tests") ||
        !fs::is_regular_file(course_root() / path, error) || !lies_below(course_root() / path, course_root() / room))
        return "";
    static constexpr std::string_view endings[] = {".glsl", ".h", ".vert", ".geom", ".frag", ".comp"};
    if (std::ranges::find(endings, path.extension().string()) == std::end(endings)) return "";
    std::ifstream source(course_root() / path);
    std::string text;
    for (int i = 0; i < number && std::getline(source, text); ++i) {}
    return !source ? "" : "\n    " + (text.size() > 200 ? text.substr(0, 200) + " ..." : text);
}

// "file:line: message" and the line itself, from glslang's "ERROR: file:line: message".
std::string readable(const std::string& log) {
    static const std::regex pattern(R"(ERROR: ("?)([^:"]+)\1:(\d+): (.*))");
    std::istringstream in(log);
    std::string line, result;
    while (std::getline(in, line)) {
        std::smatch match;
        if (!std::regex_match(line, match, pattern)) continue;
        const std::string file = match[2];
        const int number = std::stoi(match[3]);
        const std::string message = match[4];
        if (message.find("compilation terminated") != message.npos) continue;
        result += fmt::format("{}{}:{}: {}", result.empty() ? "" : "\n", file, number, message);
        result += line_of(file, number);
    }
    return result.empty() ? log : result;
}

std::vector<uint32_t> compile_now(Stage stage, const std::string& text, const std::string& name) {
    static const bool initialised = glslang::InitializeProcess();
    (void)initialised;
    const char* string = text.c_str();
    const int length = static_cast<int>(text.size());
    const char* shown = name.c_str();
    glslang::TShader shader(language(stage));
    shader.setStringsWithLengthsAndNames(&string, &length, &shown, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, language(stage), glslang::EShClientVulkan, 460);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
    shader.setAutoMapBindings(true);
    shader.setAutoMapLocations(true);
    const auto rules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    if (!shader.parse(GetDefaultResources(), 460, false, rules)) throw ShaderError(readable(shader.getInfoLog()));
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(rules) || !program.mapIO()) throw ShaderError("{}: {}", name, program.getInfoLog());
    std::vector<uint32_t> spirv;
    glslang::SpvOptions options;
    glslang::GlslangToSpv(*program.getIntermediate(language(stage)), spirv, &options);
    return spirv;
}

// An entry: the words of the module, then their hash, so that a damaged file is not believed.
bool load(const fs::path& file, std::vector<uint32_t>& spirv) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    uint64_t stored = 0;
    if (bytes.size() < 20 + sizeof stored || (bytes.size() - sizeof stored) % 4 != 0) return false;
    const std::string_view words(bytes.data(), bytes.size() - sizeof stored);
    std::memcpy(&stored, bytes.data() + words.size(), sizeof stored);
    if (stored != hash_bytes(words)) return false;
    spirv.resize(words.size() / 4);
    std::memcpy(spirv.data(), words.data(), words.size());
    return true;
}

void store(const fs::path& file, const std::vector<uint32_t>& spirv) {
    std::string bytes(reinterpret_cast<const char*>(spirv.data()), spirv.size() * 4);
    const uint64_t hash = hash_bytes(bytes);
    bytes.append(reinterpret_cast<const char*>(&hash), sizeof hash);
    try {
        write_file(file, bytes);
    } catch (const InputError&) {
        // A cache that cannot be written is only slower.
    }
}

}  // namespace

const fs::path& cache_folder() {
    static const fs::path folder = [] {
        std::error_code error;
        if (const char* given = std::getenv("LIGHTWALK_CACHE")) {
            fs::create_directories(given, error);
            return fs::path(given);
        }
        fs::path beside = course_root() / "build" / "shader_cache";
        fs::create_directories(beside, error);
        if (!error) return beside;
        fs::path temporary = fs::temp_directory_path(error) / "lightwalk_shader_cache";
        fs::create_directories(temporary, error);
        return temporary;
    }();
    return folder;
}

std::vector<uint32_t> compile(Stage stage, const std::string& flat_text, const std::string& name) {
    const std::string key =
        fmt::format("{} glslang {} spirv 1.5\n", static_cast<int>(stage), glslang::GetSpirvGeneratorVersion());
    const fs::path file = cache_folder() / fmt::format("{:016x}{:016x}.spv", hash_bytes(flat_text, hash_bytes(key)),
                                                       hash_bytes(flat_text, hash_bytes(key, 7)));
    std::vector<uint32_t> spirv;
    if (load(file, spirv)) return spirv;
    spirv = compile_now(stage, flat_text, name);
    store(file, spirv);
    return spirv;
}

std::string validate_spirv(const std::vector<uint32_t>& spirv) {
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string messages;
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* text) {
        messages += (messages.empty() ? "" : "; ") + std::string(text);
    });
    spvtools::ValidatorOptions options;
    options.SetScalarBlockLayout(true);
    return tools.Validate(spirv.data(), spirv.size(), options) ? "" : messages.empty() ? "invalid" : messages;
}

}  // namespace lightwalk
