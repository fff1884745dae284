// Pipeline descriptions, and the library that builds their variants on first use.
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

#include "common/base/error.h"
#include "common/gpu/device.h"
#include "common/gpu/glsl.h"
#include "common/gpu/reflect.h"
#include "common/gpu/states.h"

namespace lightwalk {

/// Description of a pipeline. Toggles and knobs select the variant. all() lets the build precompile every one.
class Pipeline {
  public:
    struct Graphics {
        std::string vertex, geometry, fragment;  ///< paths below shaders/
        VkCullModeFlags cull = VK_CULL_MODE_BACK_BIT;
        bool depth_test = true, depth_write = true;
        Compare depth_compare = Compare::greater_or_equal;
        DepthBias depth_bias;
        bool depth_clamp = false;  ///< clamps depth beyond the near and far planes instead of clipping
        PerTarget<Blend> blend = Blend::opaque;
        PerTarget<VkColorComponentFlags> color_write = write_rgba;
        bool alpha_to_coverage = false;  ///< multisampling: alpha determines the covered samples
        VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        Macros macros;  ///< take precedence over all other macros
    };
    struct Compute {
        std::string shader;
        Macros macros;
        std::string source;  ///< GLSL text instead of a file; `shader` is its name in messages
    };
    /// Messages name `where`, the pipeline's statement.
    explicit Pipeline(Graphics desc, SourceLocation where = SourceLocation::current());
    explicit Pipeline(Compute desc, SourceLocation where = SourceLocation::current());
    ~Pipeline();
    Pipeline(const Pipeline&) = delete;

    static const std::vector<Pipeline*>& all();
    std::vector<std::string> shaders() const;

    const Macros& macros() const { return is_compute ? compute.macros : graphics.macros; }

    Graphics graphics;
    Compute compute;
    bool is_compute = false;
    uint64_t id;
    SourceLocation where;
};

inline Pipeline graphics(Pipeline::Graphics desc, SourceLocation where = SourceLocation::current()) {
    return Pipeline(std::move(desc), where);
}
inline Pipeline compute(Pipeline::Compute desc, SourceLocation where = SourceLocation::current()) {
    return Pipeline(std::move(desc), where);
}

struct TargetFormats {
    std::vector<VkFormat> color;
    VkFormat depth = VK_FORMAT_UNDEFINED;
    bool depth_read_only = false;
    uint32_t samples = 1;
    std::optional<BlendOverride> blend_override;
    auto operator<=>(const TargetFormats&) const = default;
};

struct BuiltPipeline {
    explicit BuiltPipeline(Device& device) : device_(device) {}
    ~BuiltPipeline();
    BuiltPipeline(const BuiltPipeline&) = delete;
    VkPipeline handle = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    std::vector<Binding> bindings;  ///< sorted by number, used ones first; index_names() after changes
    uint32_t descriptors = 0;
    bool samples_and_writes = false;  ///< has both sampled and writable storage images
    glm::uvec3 local_size{1};
    std::string mismatch;  ///< disagreement of the fragment shader's outputs with the targets; empty: none
    std::vector<VkShaderModule> modules;

    void index_names();
    const Binding* find(const BindingName& name) const;

  private:
    Device& device_;
    std::vector<uint16_t> by_hash_;  ///< open-addressing hash table of binding number + 1; 0: empty
};

class PipelineLibrary {
  public:
    explicit PipelineLibrary(Device& device) : device_(device) {}

    /// Interactive mode: a variant that fails to compile is replaced by the last valid one, with an entry in `errors`.
    bool keep_last_good = false;
    /// Errors by pipeline, "file:line: message". Filled by get(); clear before a frame.
    std::map<std::string, std::string> errors;

    /// Variant for the current toggles and macros. Precedence, highest first: the pipeline's macros, then `macros` from
    /// last to first. Macros that the shaders do not name are ignored. Null if it failed and keep_last_good is set;
    /// otherwise throws ShaderError.
    const BuiltPipeline* get(const Pipeline& pipeline, const TargetFormats& formats,
                             std::span<const Macros* const> macros);

    /// Discards everything built from changed files; true if any did. Files modified less than `rest` ago, and empty
    /// ones for two seconds, may be incomplete and are left to a later call.
    bool forget_changed_files(std::chrono::milliseconds rest = {});

    /// Rebuilds everything on next use. The last valid variants stay as fallback.
    void rebuild();

    /// Destroys everything built. No frame may be in flight.
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
    struct Known {
        uint64_t pipeline;
        TargetFormats formats;
        std::string toggles;
        std::vector<Macros> macros;
        const BuiltPipeline* built;
    };
    std::unordered_multimap<uint64_t, Known> known_;  ///< by a hash; the whole key is compared
    Device& device_;
    std::map<std::string, Variant> variants_;
    std::map<std::string, std::string> last_good_;
    std::map<std::filesystem::path, std::filesystem::file_time_type> files_;
};

VkPipeline create_graphics(Device& device, const Pipeline::Graphics& desc, const TargetFormats& formats,
                           const std::vector<VkPipelineShaderStageCreateInfo>& stages, VkPipelineLayout layout);

/// Text of the fixed-function state, distinguishing pipelines with equal shaders.
std::string state_key(const Pipeline::Graphics& desc, const TargetFormats& formats);

/// Flattened source of all stages, with `macros` and the pipeline's own.
std::vector<FlatShader> flatten_stages(const Pipeline& pipeline, const Macros& macros);

struct CompiledStages {
    std::vector<Stage> stages;
    std::vector<std::vector<uint32_t>> spirv;
    std::vector<std::string> names;
};
CompiledStages compile_stages(const Pipeline& pipeline, const std::vector<FlatShader>& flat);

/// Numbers the bindings by name and patches the modules; `last` receives the reflection of the last stage. Throws
/// ShaderError if stages declare one name differently, or if one reads what the stage before it does not write.
std::vector<Binding> assign_bindings(CompiledStages& stages, Reflection* last = nullptr);

}  // namespace lightwalk
