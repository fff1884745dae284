// GLSL to SPIR-V: includes, exercise toggles, compilation, cache.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/gpu/macros.h"

namespace lightwalk {

/// Compilation error. The message gives file and line and shows the source line.
struct ShaderError : Failure {
    using Failure::Failure;
};

enum class Stage { vertex, geometry, fragment, compute };

/// GLSL with all includes expanded, separated by #line directives.
struct FlatShader {
    std::string text;
    std::vector<std::filesystem::path> files;  ///< all files read, watched for edits
    std::string sealed;
};

/// Reads shaders/`name` and expands its includes, each file once. Include paths are relative to shaders/. A missing
/// "NN_name/f.glsl" is replaced by exercise/f.glsl or solution/f.glsl, depending on the toggle "NN.f". Chapter NN may
/// include chapters up to NN, and files that `macros` substitutes. Only macros that the text names are defined. Throws
/// ShaderError: missing file, later chapter, include within #if, #if of an undefined macro. `stated` begins the message
/// for a missing file `name`.
FlatShader flatten(const std::string& name, const Macros& macros, const std::string& stated);

/// Expands includes without defining macros: all text that a shader may use, after the substitutions of `files`.
FlatShader flatten_bare(const std::string& name, const Macros& files, const std::string& stated);

/// True if `text` contains `name` as a whole word: METHOD is not in LIGHTS_METHOD.
bool names_macro(std::string_view text, std::string_view name);

/// Expands GLSL in memory, with the include rights of `chapter` ("99": all chapters).
FlatShader flatten_text(const std::string& text, const std::string& name, const std::string& chapter,
                        const Macros& macros);

/// SPIR-V 1.5 for Vulkan 1.3, cached by text and compiler version. `name` appears in error messages. The cache is
/// $LIGHTWALK_CACHE, else build/shader_cache, else a temporary folder; processes may share it, since entries are
/// written atomically and damaged ones are rebuilt. Throws ShaderError, also for numbers of bindings and for a compute
/// shader without a local size.
std::vector<uint32_t> compile(Stage stage, const std::string& flat_text, const std::string& name);

/// Message of spirv-val for Vulkan 1.3 with scalar block layout; empty: valid.
std::string validate_spirv(const std::vector<uint32_t>& spirv);

Stage stage_of(const std::string& file_name);

}  // namespace lightwalk
