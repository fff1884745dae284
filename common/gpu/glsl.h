// From GLSL on disk to SPIR-V: includes, exercise toggles, compilation and the cache.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/gpu/macros.h"

namespace lightwalk {

/// A shader that does not compile: its text names file and line and shows the line.
struct ShaderError : Failure {
    using Failure::Failure;
};

enum class Stage { vertex, geometry, fragment, compute };

/// GLSL with every #include replaced by the file's text and #line directives in between.
struct FlatShader {
    std::string text;
    std::vector<std::filesystem::path> files;  ///< all files read, to watch for edits
    std::string sealed;                        ///< its name where it is sealed (sealed.h)
};

/// Reads shaders/`name` and its includes. An include is a path below shaders/; a missing "NN_name/f.glsl" is
/// exercise/f.glsl or solution/f.glsl of that folder, as the toggle "NN.f" selects. A file is included once. Chapter
/// NN may include chapters up to NN, and files that `macros` substitutes. Only macros named in the text are defined.
/// Throws ShaderError (missing, later chapter, include within #if, #if of an undefined macro).
FlatShader flatten(const std::string& name, const Macros& macros);

/// The same without evaluating macros: all text that a shader may use, with the substitutions of `files`.
FlatShader flatten_bare(const std::string& name, const Macros& files = {});

/// True if `text` has `name` as a word of its own: METHOD is not in LIGHTS_METHOD.
bool names_macro(std::string_view text, std::string_view name);

/// The same for a text in memory, with the include rights of chapter `chapter` ("99": any).
FlatShader flatten_text(const std::string& text, const std::string& name, const std::string& chapter,
                        const Macros& macros);

/// SPIR-V 1.5 for Vulkan 1.3, from the cache where it holds this very text. `name` is for messages. Throws ShaderError.
/// The cache ($LIGHTWALK_CACHE, else build/shader_cache below the course, else a temporary folder) may be shared by
/// processes: an entry appears whole or not at all, and one that is damaged is rebuilt.
std::vector<uint32_t> compile(Stage stage, const std::string& flat_text, const std::string& name);

/// Message of spirv-val for Vulkan 1.3 with scalar block layout; empty: valid.
std::string validate_spirv(const std::vector<uint32_t>& spirv);

Stage stage_of(const std::string& file_name);

}  // namespace lightwalk
