#include "common/gpu/pipeline.h"

#include <algorithm>
#include <bit>
#include <set>
#include <unordered_set>

#include "common/base/epoch.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/base/kept.h"
#include "common/base/preparing.h"
#include "common/base/shared_lock.h"
#include "common/gpu/gpu_work.h"
#include "common/gpu/hidden_blocks.h"
#include "common/gpu/sealed.h"

namespace lightwalk {
namespace {

std::vector<Pipeline*>& live() {
    static std::vector<Pipeline*> list;
    return list;
}

VkShaderStageFlagBits stage_bit(Stage stage) {
    switch (stage) {
        case Stage::vertex:
            return VK_SHADER_STAGE_VERTEX_BIT;
        case Stage::geometry:
            return VK_SHADER_STAGE_GEOMETRY_BIT;
        case Stage::fragment:
            return VK_SHADER_STAGE_FRAGMENT_BIT;
        case Stage::compute:
            return VK_SHADER_STAGE_COMPUTE_BIT;
    }
    return VK_SHADER_STAGE_ALL;
}

std::string identity(const Pipeline& p, const TargetFormats& formats) {
    std::string key;
    for (const std::string& shader : p.shaders()) key += shader + " ";
    if (p.is_compute) {
        for (const auto& [name, value] : p.macros()) key += fmt::format("{}={} ", name, value);
        return key + (p.compute.source.empty() ? "" : std::to_string(std::hash<std::string>{}(p.compute.source)));
    }
    for (const auto& [name, value] : p.macros()) key += fmt::format("{}={} ", name, value);
    return key + state_key(p.graphics, formats);
}

// Files edited while this process runs. Shaders compiled from them are not kept: an hour of edits would fill the cache.
std::set<std::filesystem::path>& edited() {
    static std::set<std::filesystem::path> files;
    return files;
}

uint64_t next_id() {
    static uint64_t count = 0;
    return ++count;
}

}  // namespace

Pipeline::Pipeline(Graphics desc, SourceLocation at) : graphics(std::move(desc)), id(next_id()), where(at) {
    live().push_back(this);
}
Pipeline::Pipeline(Compute desc, SourceLocation at)
    : compute(std::move(desc)), is_compute(true), id(next_id()), where(at) {
    live().push_back(this);
}
Pipeline::~Pipeline() { std::erase(live(), this); }
const std::vector<Pipeline*>& Pipeline::all() { return live(); }

std::vector<std::string> Pipeline::shaders() const {
    if (is_compute) return {compute.shader};
    std::vector<std::string> result{graphics.vertex};
    if (!graphics.geometry.empty()) result.push_back(graphics.geometry);
    if (!graphics.fragment.empty()) result.push_back(graphics.fragment);
    return result;
}

BuiltPipeline::~BuiltPipeline() {
    vkDestroyPipeline(device_.handle, handle, nullptr);
    vkDestroyPipelineLayout(device_.handle, layout, nullptr);
    vkDestroyDescriptorSetLayout(device_.handle, set_layout, nullptr);
    for (const VkShaderModule module : modules) vkDestroyShaderModule(device_.handle, module, nullptr);
}

// Load factor of at most 1/4, so that look-ups of absent names end after about one probe.
void BuiltPipeline::index_names() {
    by_hash_.assign(std::bit_ceil(4 * bindings.size() + 1), 0);
    const size_t mask = by_hash_.size() - 1;
    for (const Binding& binding : bindings) {
        size_t at = binding.hash & mask;
        while (by_hash_[at]) at = (at + 1) & mask;
        by_hash_[at] = static_cast<uint16_t>(binding.number + 1);
    }
}

const Binding* BuiltPipeline::find(const BindingName& name) const {
    const size_t mask = by_hash_.size() - 1;
    for (size_t at = name.hash & mask; by_hash_[at]; at = (at + 1) & mask)
        if (const Binding& binding = bindings[by_hash_[at] - 1u]; binding.hash == name.hash) return &binding;
    return nullptr;
}

std::vector<FlatShader> flatten_stages(const Pipeline& pipeline, const Macros& macros) {
    Macros all = macros;
    all.add(pipeline.macros());
    std::vector<FlatShader> result;
    for (const std::string& shader : pipeline.shaders()) {
        const std::string sealed = sealed_name(shader, all, pipeline.compute.source);
        if (only_sealed()) {
            result.push_back({.text = sealed, .files = {}, .sealed = sealed});
            continue;
        }
        result.push_back(pipeline.compute.source.empty() ? flatten(shader, all, place_of(pipeline.where))
                                                         : flatten_text(pipeline.compute.source, shader, "99", all));
        result.back().sealed = sealed;
    }
    return result;
}

CompiledStages compile_stages(const Pipeline& pipeline, const std::vector<FlatShader>& flat) {
    CompiledStages result;
    result.names = pipeline.shaders();
    for (size_t i = 0; i < flat.size(); ++i) {
        result.stages.push_back(pipeline.is_compute ? Stage::compute : stage_of(result.names[i]));
        result.spirv.push_back(only_sealed() ? read_sealed(flat[i].sealed)
                                             : compile(result.stages[i], flat[i].text, result.names[i]));
        seal(flat[i].sealed, result.spirv.back());
    }
    return result;
}

namespace {

// Vertices are read from buffers, so that the first stage has no inputs.
void check_inputs(const CompiledStages& stages, const std::vector<Reflection>& reflections, size_t stage) {
    const auto fail = [&](const Varying& in, const std::string& why) {
        throw ShaderError("shaders/{}: 'in {}' {}", stages.names[stage], in.name, why);
    };
    for (const Varying& in : reflections[stage].inputs) {
        if (stage == 0) fail(in, "is a vertex attribute, and no pipeline has any; read the buffer 'vertices'");
        const auto& outputs = reflections[stage - 1].outputs;
        const auto out = std::ranges::find(outputs, in.location, &Varying::location);
        const std::string& before = stages.names[stage - 1];
        if (out == outputs.end())
            fail(in, fmt::format("is at location {}, to which {} writes nothing", in.location, before));
        if (out->type != in.type || out->components < in.components)
            fail(in, fmt::format("differs in type from 'out {}' of {}", out->name, before));
    }
}

// One letter and number for each component: R8G8B8A8Unorm has four.
size_t components_of(VkFormat format) {
    const std::string name = name_of(format);
    size_t count = 0;
    for (size_t i = 1; i < name.size(); ++i)
        count += std::isdigit(static_cast<unsigned char>(name[i])) && std::string("RGBA").find(name[i - 1]) < 4;
    return count;
}

std::string target_mismatch(const Pipeline::Graphics& desc, const std::vector<Varying>& outputs,
                            const TargetFormats& formats) {
    if (std::ranges::count(formats.color, VK_FORMAT_UNDEFINED)) return {};  // depth alone
    for (size_t i = 0; i < formats.color.size(); ++i) {
        const VkFormat format = formats.color[i];
        if (desc.color_write[i] == write_nothing) continue;
        const auto out = std::ranges::find(outputs, i, &Varying::location);
        if (out == outputs.end())
            return fmt::format("nothing is written to color target {}; declare layout(location = {}) out", i, i);
        constexpr const char* types[] = {"floats", "integers", "unsigned integers"};
        if (out->type != texels_of(format))
            return fmt::format("'out {}' has {}, and its target is {}", out->name, types[size_t(out->type)],
                               name_of(format));
        const size_t written = std::min<size_t>(components_of(format), desc.color_write[i] == write_rgb ? 3 : 4);
        if (out->components < written)
            return fmt::format("'out {}' has {} components, and {} of its target, {}, are written", out->name,
                               out->components, written, name_of(format));
    }
    return {};
}

}  // namespace

std::vector<Binding> assign_bindings(CompiledStages& stages, Reflection* last) {
    std::map<std::string, Binding> merged;
    std::vector<Reflection> reflections;
    for (size_t i = 0; i < stages.stages.size(); ++i) {
        try {
            reflections.push_back(reflect(stages.spirv[i]));
        } catch (const Failure& e) {
            const bool is_file = std::filesystem::exists(course_root() / "shaders" / stages.names[i]);
            throw ShaderError("{}{}: {}", is_file ? "shaders/" : "", stages.names[i], e.what());
        }
        if (stages.stages[i] != Stage::compute) check_inputs(stages, reflections, i);
        for (const Binding& binding : reflections.back().bindings) {
            auto [it, added] = merged.emplace(binding.name, binding);
            if (!added && (it->second.compares != binding.compares || it->second.type != binding.type ||
                           it->second.bytes != binding.bytes || it->second.count != binding.count ||
                           it->second.view_type != binding.view_type))
                throw ShaderError("{}: '{}' is declared otherwise in another stage", stages.names[i], binding.name);
            it->second.stages |= stage_bit(stages.stages[i]);
            it->second.used |= binding.used;
            it->second.writable |= binding.writable;
            it->second.readable |= binding.readable;
        }
    }
    uint32_t number = 0;
    uint32_t first = 0;
    for (const bool used : {true, false})
        for (auto& [name, binding] : merged) {
            if (binding.used != used) continue;
            binding.number = number++;
            binding.first = first;
            first += used ? binding.count : 0;
        }
    for (size_t i = 0; i < reflections.size(); ++i)
        for (const Binding& binding : reflections[i].bindings)
            stages.spirv[i][binding.offset_of_number] = merged.at(binding.name).number;
    if (last) *last = std::move(reflections.back());
    std::vector<Binding> result(merged.size());
    for (auto& [name, binding] : merged) result[binding.number] = std::move(binding);
    return result;
}

const BuiltPipeline* PipelineLibrary::get(const Pipeline& pipeline, const TargetFormats& formats,
                                          std::span<const Macros* const> macros) {
    Hash key;
    key.add(pipeline.id);
    for (const Macros* scope : macros) key.add(scope->hash());
    const auto equal = [](const Macros* a, const Macros& b) { return *a == b; };
    const auto [first, last] = known_.equal_range(key.value);
    for (auto it = first; it != last; ++it)
        if (const Known& one = it->second;
            one.pipeline == pipeline.id && one.formats == formats && one.toggles == Exercises::state() &&
            std::equal(macros.begin(), macros.end(), one.macros.begin(), one.macros.end(), equal))
            return one.built;
    Known known{.pipeline = pipeline.id, .formats = formats, .toggles = Exercises::state(), .macros = {}, .built = {}};
    Macros all;
    for (const Macros* scope : macros) {
        all.add(*scope);
        known.macros.push_back(*scope);
    }
    try {
        known.built = find(pipeline, formats, all);
        return known_.emplace(key.value, std::move(known))->second.built;
    } catch (const ShaderError& e) {
        if (!keep_last_good) throw;
        const std::string same = identity(pipeline, formats);
        errors[same] = e.what();
        const auto good = last_good_.find(same + Exercises::state());
        return good == last_good_.end() ? nullptr : variants_[good->second].built.get();
    }
}

const BuiltPipeline* PipelineLibrary::find(const Pipeline& pipeline, const TargetFormats& formats,
                                           const Macros& macros) {
    const std::vector<FlatShader> flat = flatten_stages(pipeline, macros);
    watch(flat);
    const std::string same = identity(pipeline, formats);
    std::string key = same;
    for (const FlatShader& shader : flat) key += fmt::format(" {}", hash_bytes(shader.text));
    Variant& variant = variants_[key];
    if (!variant.error.empty()) throw ShaderError(variant.error);  // failed until the file is edited
    try {
        if (!variant.built) {
            if (const auto& files = flat.back().files; !files.empty()) announce(files.front().filename().string());
            const auto is_edited = [](const auto& file) { return edited().contains(file); };
            const SkipKeeping edits(std::ranges::any_of(
                flat, [&](const FlatShader& shader) { return std::ranges::any_of(shader.files, is_edited); }));
            auto built = unlocked([&] { return build(pipeline, formats, flat); });
            if (!variant.built) variant.built = std::move(built);  // another thread may have been faster
        }
    } catch (const ShaderError& e) {
        variant.error = e.what();
        throw;
    }
    last_good_[same + Exercises::state()] = key;  // the student's version never stands in for the reference, nor back
    return variant.built.get();
}

// Called before compiling, so that edits are noticed after an error as well.
void PipelineLibrary::watch(const std::vector<FlatShader>& flat) {
    for (const FlatShader& shader : flat)
        for (const auto& file : shader.files) {
            std::error_code error;
            files_.try_emplace(file, std::filesystem::last_write_time(file, error));
        }
}

bool PipelineLibrary::forget_changed_files(std::chrono::milliseconds rest) {
    bool changed = false;
    for (auto& [file, time] : files_) {
        std::error_code error;
        const auto written = std::filesystem::last_write_time(file, error);
        if (error || written == time) continue;
        const auto age = std::filesystem::file_time_type::clock::now() - written;
        const bool is_empty = rest.count() > 0 && std::filesystem::file_size(file, error) == 0;
        if (std::chrono::abs(age) < (is_empty ? std::chrono::seconds(2) : rest)) continue;
        time = written;
        edited().insert(file);
        changed = true;
    }
    if (changed) {
        rebuild();
        Exercises::shaders_were_edited();
    }
    return changed;
}

// Pipelines that nothing has used since the last edit, and errors, are of earlier texts: they are destroyed.
void PipelineLibrary::rebuild() {
    std::unordered_set<const BuiltPipeline*> used;
    for (const auto& [hash, known] : known_) used.insert(known.built);
    for (const auto& [same, key] : last_good_)
        if (const auto good = variants_.find(key); good != variants_.end()) used.insert(good->second.built.get());
    known_.clear();
    const auto is_gone = [&](const auto& entry) {
        return entry.second.built ? !used.contains(entry.second.built.get()) : !entry.second.error.empty();
    };
    if (std::ranges::none_of(variants_, is_gone)) return;
    vkDeviceWaitIdle(device_.handle);  // a frame in flight may have one
    std::erase_if(variants_, is_gone);
}

void PipelineLibrary::clear() {
    known_.clear();
    variants_.clear();
    last_good_.clear();
    errors.clear();
}

std::unique_ptr<BuiltPipeline> PipelineLibrary::build(const Pipeline& pipeline, const TargetFormats& formats,
                                                      const std::vector<FlatShader>& flat) {
    ++gpu_work.pipelines;
    CompiledStages stages = compile_stages(pipeline, flat);

    auto built = std::make_unique<BuiltPipeline>(device_);
    Reflection last;
    built->bindings = assign_bindings(stages, &last);
    built->local_size = last.local_size;
    if (stages.stages.back() == Stage::fragment)
        built->mismatch = target_mismatch(pipeline.graphics, last.outputs, formats);
    if (!built->mismatch.empty()) return built;  // refused by the pass, which knows its statement
    const VkPhysicalDeviceLimits& limits = device_.properties.limits;
    const glm::uvec3& local = built->local_size;
    if (const uint32_t most = limits.maxComputeWorkGroupInvocations; local.x * local.y * local.z > most)
        throw ShaderError("shaders/{}: a local size of {}×{}×{} is {} threads; this device has at most {}",
                          stages.names[0], local.x, local.y, local.z, local.x * local.y * local.z, most);
    if (const uint32_t most = limits.maxComputeSharedMemorySize; last.shared_bytes > most)
        throw ShaderError("shaders/{}: its shared variables take {} bytes; this device has at most {}", stages.names[0],
                          last.shared_bytes, most);
    std::vector<VkDescriptorSetLayoutBinding> entries;
    bool samples = false, writes = false;
    for (const Binding& binding : built->bindings) {
        if (!binding.used) break;
        entries.push_back({binding.number, binding.type, binding.count, binding.stages, nullptr});
        built->descriptors += binding.count;
        samples |= binding.type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        writes |= binding.type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE && binding.writable;
    }
    built->samples_and_writes = samples && writes;
    built->index_names();
    const VkDescriptorSetLayoutCreateInfo set_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                                   .bindingCount = static_cast<uint32_t>(entries.size()),
                                                   .pBindings = entries.data()};
    check(vkCreateDescriptorSetLayout(device_.handle, &set_info, nullptr, &built->set_layout), "set layout");
    const VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                 .setLayoutCount = 1,
                                                 .pSetLayouts = &built->set_layout,
                                                 .pushConstantRangeCount = device_.software_paths ? 1u : 0u,
                                                 .pPushConstantRanges = &hidden_index};
    check(vkCreatePipelineLayout(device_.handle, &layout_info, nullptr, &built->layout), "pipeline layout");

    std::vector<VkPipelineShaderStageCreateInfo> stage_infos;
    for (size_t i = 0; i < stages.stages.size(); ++i) {
        if (device_.software_paths) hide_blocks(stages.spirv[i]);
        const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                            .codeSize = stages.spirv[i].size() * 4,
                                            .pCode = stages.spirv[i].data()};
        check(vkCreateShaderModule(device_.handle, &info, nullptr, &built->modules.emplace_back()), "shader module");
        stage_infos.push_back({.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                               .stage = stage_bit(stages.stages[i]),
                               .module = built->modules.back(),
                               .pName = "main"});
    }
    if (pipeline.is_compute) {
        const VkComputePipelineCreateInfo info{
            .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO, .stage = stage_infos[0], .layout = built->layout};
        check(vkCreateComputePipelines(device_.handle, VK_NULL_HANDLE, 1, &info, nullptr, &built->handle),
              pipeline.compute.shader.c_str());
    } else {
        built->handle = create_graphics(device_, pipeline.graphics, formats, stage_infos, built->layout);
    }
    device_.set_name(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(built->handle), stages.names.back());
    return built;
}

}  // namespace lightwalk
