// Pipelines as a chapter states them, and the library that builds each variant when it is first used.
#pragma once
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "common/gpu/device.h"
#include "common/gpu/glsl.h"
#include "common/gpu/reflect.h"
#include "common/gpu/states.h"

namespace lightwalk {

/// A pipeline's description. It builds nothing by itself: the variant in use follows the toggles and choices of the
/// moment. Every live one is in Pipeline::all(), so that the build can compile them all.
class Pipeline {
  public:
    struct Graphics {
        std::string vertex, geometry, fragment;  ///< below shaders/
        VkCullModeFlags cull = VK_CULL_MODE_BACK_BIT;
        bool depth_test = true, depth_write = true;
        Compare depth_compare = Compare::greater_or_equal;  ///< compares a fragment's depth with the stored depth
        DepthBias depth_bias;
        bool depth_clamp = false;  ///< clamps depth outside the near and far planes instead of clipping
        PerTarget<Blend> blend = Blend::opaque;
        PerTarget<VkColorComponentFlags> color_write = write_rgba;
        bool alpha_to_coverage = false;  ///< with several samples: alpha says how many of them are covered
        VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        Macros macros;  ///< its own, which overrule all others
    };
    struct Compute {
        std::string shader;  ///< below shaders/
        Macros macros;
        std::string source;  ///< a text instead of a file; `shader` is then its name in messages
    };
    explicit Pipeline(Graphics desc);
    explicit Pipeline(Compute desc);
    ~Pipeline();
    Pipeline(const Pipeline&) = delete;

    static const std::vector<Pipeline*>& all();
    std::vector<std::string> shaders() const;

    const Macros& macros() const { return is_compute ? compute.macros : graphics.macros; }

    Graphics graphics;
    Compute compute;
    bool is_compute = false;
    uint64_t id;  ///< of this one, never used again
};

inline Pipeline graphics(Pipeline::Graphics desc) { return Pipeline(std::move(desc)); }
inline Pipeline compute(Pipeline::Compute desc) { return Pipeline(std::move(desc)); }

/// Adds a number to a hash. Small inputs must not cancel: two pipelines that differed in one bit each of id and
/// target were once confused. So the first is mixed into 1, and every number is mixed before it is combined.
uint64_t mixed(uint64_t hash, uint64_t value);

/// Target formats of a graphics pipeline.
struct TargetFormats {
    std::vector<VkFormat> color;
    VkFormat depth = VK_FORMAT_UNDEFINED;
    bool depth_read_only = false;  ///< depth is tested and never written, even if the pipeline writes depth
    uint32_t samples = 1;
    std::optional<Mixing> mixing;  ///< overrules the pipeline's blending and writing of depth
    auto operator<=>(const TargetFormats&) const = default;
    uint64_t hash() const;
};

/// One variant, built.
/// Large (5 functions, 10 members): Vulkan's handles.
struct BuiltPipeline {
    explicit BuiltPipeline(Device& device) : device_(device) {}
    ~BuiltPipeline();
    BuiltPipeline(const BuiltPipeline&) = delete;
    VkPipeline handle = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    std::vector<Binding> bindings;  ///< by number; those in use come first; then index_names()
    uint32_t descriptors = 0;       ///< all elements of those in use
    glm::uvec3 local_size{1};
    std::vector<VkShaderModule> modules;

    void index_names();
    const Binding* find(const BindingName& name) const;  ///< null: no such binding

  private:
    Device& device_;
    std::vector<uint16_t> by_hash_;  ///< numbers counted from 1, at their names' hashes or behind; 0: free
};

class PipelineLibrary {
  public:
    explicit PipelineLibrary(Device& device) : device_(device) {}

    /// Window mode: a variant that does not compile leaves the last good one in place, and `errors` says why.
    bool keep_last_good = false;
    /// By pipeline: file:line: message. Every get() of a failed variant adds its error, so after clearing it before a
    /// frame it holds that frame's errors.
    std::map<std::string, std::string> errors;

    /// The variant for the current toggles and the macros: the pipeline's own take precedence over the last of
    /// `macros`, which takes precedence over earlier ones. Macros that the shaders do not name make no variant. Null
    /// if it failed and keep_last_good is set; else throws ShaderError.
    const BuiltPipeline* get(const Pipeline& pipeline, const TargetFormats& formats,
                             std::span<const Macros* const> macros);

    /// Checks files for changes and discards everything built from changed ones. True if one changed. A file written
    /// less than `rest` ago may be incomplete and is left for a later call; an empty one, which most editors create
    /// first, for two seconds.
    bool forget_changed_files(std::chrono::milliseconds rest = {});

    /// Rebuilds everything on its next use, and keeps the last good one if that fails.
    void rebuild();

    /// Forgets all that was built; nothing may be in flight.
    void clear();

  private:
    const BuiltPipeline* find(const Pipeline& pipeline, const TargetFormats& formats, const Macros& macros);
    std::unique_ptr<BuiltPipeline> build(const Pipeline& pipeline, const TargetFormats& formats,
                                         const std::vector<FlatShader>& flat);
    void watch(const std::vector<FlatShader>& flat);
    struct Variant {
        std::unique_ptr<BuiltPipeline> built;
        std::string error;
    };
    /// Hashes of successful get() calls, with their results.
    std::unordered_map<uint64_t, const BuiltPipeline*> known_;
    Device& device_;
    std::map<std::string, Variant> variants_;       ///< by pipeline, formats and the text that was compiled
    std::map<std::string, std::string> last_good_;  ///< pipeline and formats → variant
    std::map<std::filesystem::path, std::filesystem::file_time_type> files_;
};

VkPipeline create_graphics(Device& device, const Pipeline::Graphics& desc, const TargetFormats& formats,
                           const std::vector<VkPipelineShaderStageCreateInfo>& stages, VkPipelineLayout layout);

/// State that distinguishes pipelines of the same shaders.
std::string state_key(const Pipeline::Graphics& desc, const TargetFormats& formats);

/// A pipeline's stages as text, with `macros` and the pipeline's own.
std::vector<FlatShader> flatten_stages(const Pipeline& pipeline, const Macros& macros);

/// The same compiled.
struct CompiledStages {
    std::vector<Stage> stages;
    std::vector<std::vector<uint32_t>> spirv;
    std::vector<std::string> names;
};
CompiledStages compile_stages(const Pipeline& pipeline, const std::vector<FlatShader>& flat);

/// Numbers the bindings of all stages by name, those in use first, and writes the numbers into the modules. Returns them,
/// merged, by number. Throws ShaderError if two stages use one name for different things.
std::vector<Binding> assign_bindings(CompiledStages& stages, glm::uvec3* local_size = nullptr);

}  // namespace lightwalk
