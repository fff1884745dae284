#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <regex>
#include <spirv-tools/libspirv.hpp>
#include <sstream>

#include "common/base/files.h"
#include "common/base/kept.h"
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

// Source line for a message; empty unless `file` is the course's, since #line may name any file.
std::string line_of(const std::string& file, int number) {
    const fs::path path = fs::path(file).lexically_normal();
    const std::string room = path.empty() ? "" : path.begin()->string();
    std::error_code error;
    // Students see this message in grading, and a syntax error may end within a reference solution that follows.
    if (std::getenv("LIGHTWALK_SANDBOXED") && std::ranges::count(path, fs::path("solution"))) return "";
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

// The first error of each line: those that follow in it are its consequences.
std::string readable(const std::string& log) {
    static const std::regex pattern(R"(ERROR: ("?)([^:"]+)\1:(\d+): (.*))");
    std::istringstream in(log);
    std::string line, result, last_place;
    while (std::getline(in, line)) {
        std::smatch match;
        if (!std::regex_match(line, match, pattern)) continue;
        const std::string file = match[2];
        const int number = std::stoi(match[3]);
        std::string message = match[4];
        message.erase(message.find_last_not_of(' ') + 1);
        if (message.find("compilation terminated") != message.npos) continue;
        const std::string place = fmt::format("{}:{}", file, number);
        if (place == last_place) continue;
        last_place = place;
        result += (result.empty() ? "" : "\n") + place + ": " + message + line_of(file, number);
    }
    return result.empty() ? log : result;
}

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Comments as blanks; line ends stay.
std::string without_comments(std::string text) {
    for (size_t at = text.find('/'); at != text.npos; at = text.find('/', at + 1)) {
        const bool line = text.compare(at, 2, "//") == 0, block = text.compare(at, 2, "/*") == 0;
        if (!line && !block) continue;
        size_t end = text.find(line ? "\n" : "*/", at + 2);
        if (end == text.npos) end = text.size();
        if (block && end < text.size()) end += 2;
        for (; at < end; ++at)
            if (text[at] != '\n') text[at] = ' ';
    }
    return text;
}

// "file:line" of a position in flattened text.
std::string place_in(const std::string& text, size_t at) {
    const size_t directive = text.rfind("#line ", at);
    if (directive == text.npos) return "";
    const size_t name = text.find('"', directive) + 1, first = text.find('\n', directive) + 1;
    const std::string_view between = std::string_view(text).substr(first, at - first);
    return fmt::format("{}:{}", text.substr(name, text.find('"', name) - name),
                       std::atoi(text.c_str() + directive + 6) + std::ranges::count(between, '\n'));
}

// Whether a text before an image's name calls a function that only reads the image.
bool only_reads(std::string_view before) {
    static constexpr std::string_view readers[] = {"imageLoad(", "imageSize(", "imageSamples("};
    return std::ranges::any_of(readers, [&](std::string_view reader) { return before.ends_with(reader); });
}

// A writable image counts as written by its pass: one that no variant of the shader stores to would hold what was there.
void refuse_unstored(const std::string& text) {
    static const std::regex declared(R"(\b([iu]?image(?:[123]D|Cube)\w*)\s+(\w+)\s*(?:\[\w*\]\s*)?;)");
    for (std::sregex_iterator one(text.begin(), text.end(), declared), end; one != end; ++one) {
        const std::string name = (*one)[2];
        const size_t at = static_cast<size_t>(one->position()), begin = text.find_last_of(";{}#", at) + 1;
        const std::string_view qualifiers = std::string_view(text).substr(begin, at - begin);
        if (!names_macro(qualifiers, "uniform") || names_macro(qualifiers, "readonly")) continue;
        const size_t own = static_cast<size_t>(one->position(2));
        bool is_stored = false;
        for (size_t use = text.find(name); use != text.npos; use = text.find(name, use + 1)) {
            const size_t after = use + name.size();
            if (use == own || in_word(text[use - 1]) || (after < text.size() && in_word(text[after]))) continue;
            is_stored |= !only_reads(std::string_view(text).substr(0, use));
        }
        if (!is_stored)
            throw ShaderError("{}: image '{}' is never stored to; declare it readonly, or leave it out",
                              place_in(text, at), name);
    }
}

// What GLSL accepts and passes ignore: numbers of bindings, and one thread where no local size is given; and no main().
void refuse_ignored(Stage stage, const std::string& commented) {
    const std::string text = without_comments(commented);
    for (size_t at = text.find("layout"); at != text.npos; at = text.find("layout", at + 1)) {
        const size_t open = text.find_first_not_of(" \t\n", at + 6), close = text.find(')', at);
        if (open == text.npos || text[open] != '(' || close == text.npos) continue;
        const std::string_view list = std::string_view(text).substr(open, close - open);
        for (const std::string_view word : {"binding", "set"})
            for (size_t i = list.find(word); i != list.npos; i = list.find(word, i + 1))
                if (!in_word(list[i - 1]) && !in_word(text[open + i + word.size()]))
                    throw ShaderError("{}: '{}' has no effect: bindings are set by name; leave it out",
                                      place_in(text, at), word);
    }
    refuse_unstored(text);
    const size_t end = text.find_last_not_of(" \t\n");
    if (!names_macro(text, "main")) throw ShaderError("{}: no void main()", place_in(text, end));
    if (stage == Stage::compute && text.find("local_size_") == text.npos)
        throw ShaderError("{}: no local size; layout(local_size_x = 8, local_size_y = 8) in; suits images",
                          place_in(text, end));
}

std::vector<uint32_t> compile_now(Stage stage, const std::string& text, const std::string& name) {
    refuse_ignored(stage, text);
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

// Upper bound against damaged cache entries, in bytes.
constexpr size_t most_module_bytes = size_t{1} << 26;

}  // namespace

std::vector<uint32_t> compile(Stage stage, const std::string& flat_text, const std::string& name) {
    const std::string made_by =
        fmt::format("{} glslang {} spirv 1.5\n", static_cast<int>(stage), glslang::GetSpirvGeneratorVersion());
    const fs::path file = kept_file(made_by + flat_text, ".spv");
    if (const auto kept = read_kept(file, most_module_bytes); kept && kept->size() % 4 == 0) {
        std::vector<uint32_t> spirv(kept->size() / 4);
        std::memcpy(spirv.data(), kept->data(), kept->size());
        return spirv;
    }
    const std::vector<uint32_t> spirv = compile_now(stage, flat_text, name);
    keep(file, {reinterpret_cast<const char*>(spirv.data()), spirv.size() * 4});
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
