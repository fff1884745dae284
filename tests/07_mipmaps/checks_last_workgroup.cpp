// Checks of 07.last_workgroup: the whole single pass, and the order of its barriers.
#include <cstring>
#include <functional>
#include <map>

#include "07_mipmaps/mip_chain.h"
#include "07_mipmaps/texels.h"
#include "common/check/barriers.h"
#include "common/check/check.h"

using namespace lightwalk;

namespace {

struct Owner : Module {};

// Levels from the seventh on of a noisy image, made twice, compared with one dispatch per level.
void compare(Check& check, Gpu& gpu, glm::uvec2 size, uint32_t layers) {
    Owner owner;
    MipChain chain(owner, "mips");
    const Image image(gpu.device, {.name = "noise",
                                   .format = VK_FORMAT_R32_SFLOAT,
                                   .size = size,
                                   .mips = full_mip_count(size),
                                   .layers = layers});
    const ImageView all(image);
    std::vector<float> texels;
    uint32_t n = 1;
    for (size_t i = 0; i < size_t(size.x) * size.y * layers; ++i)
        texels.push_back(static_cast<float>((n = n * 1664525u + 1013904223u) >> 8) / 16777216.0f);
    const auto make = [&](const char* method, bool clear) {
        chain.method.set(method);
        Frame frame(gpu);
        frame.begin({4, 4}, 0);
        frame.upload("noise", all.mip(0), std::as_bytes(std::span(texels)));
        for (uint32_t m = 1; clear && m < image.desc.mips; ++m)
            frame.upload("nothing", all.mip(m), std::vector<std::byte>(byte_count(all.mip(m))));
        chain.record(frame, all, Content::linear);
        frame.end();
    };
    std::map<std::pair<uint32_t, uint32_t>, truth::Texels> right;
    make("box", false);
    for (uint32_t layer = 0; layer < layers; ++layer)
        for (uint32_t m = 7; m < all.mips; ++m) right[{layer, m}] = read_texels(gpu, all.layer(layer).mip(m));
    for (const char* time : {"", ", made a second time"}) {
        make("single_pass", true);
        for (const auto& [which, expected] : right) {
            const truth::Texels found = read_texels(gpu, all.layer(which.first).mip(which.second));
            double worst = 0;
            bool written = false;
            for (size_t i = 0; i < found.values.size(); ++i) {
                worst = std::max(worst, std::fabs(found.values[i].r - expected.values[i].r));
                written = written || found.values[i].r != 0;
            }
            const std::string what = fmt::format("level {} of {}x{} texels{}{}", which.second, size.x, size.y,
                                                 layers > 1 ? fmt::format(", layer {}", which.first) : "", time);
            check.expect(worst < 1e-4 || written, what + " was never written: no workgroup took itself for the last",
                         "count with atomicAdd, which returns the number before; the last one finds workgroups - 1");
            check.expect(worst < 1e-4,
                         fmt::format("{} is {:.3f} off: it was made before all tiles were there", what, worst),
                         "each workgroup counts once, not each thread; and there is a counter for each layer");
        }
    }
}

// The instructions of a function of the compiled shader in order, including its callees.
class Order {
  public:
    explicit Order(const std::vector<uint32_t>& spirv) : words_(spirv) {
        uint32_t function = 0;
        for (size_t at = 5; at < words_.size(); at += words_[at] >> 16) {
            const uint32_t op = words_[at] & 0xffff;
            if (op == 5) names_[reinterpret_cast<const char*>(&words_[at + 2])] = words_[at + 1];  // OpName
            if (op == 43) constants_[words_[at + 2]] = words_[at + 3];                             // OpConstant
            if (op == 54) function = words_[at + 2];                                               // OpFunction
            if (function) functions_[function].push_back(at);
            if (op == 56) function = 0;  // OpFunctionEnd
        }
    }

    enum class Step { count, memory_barrier, barrier };

    std::vector<Step> steps(const std::string& name) const {
        std::vector<Step> result;
        for (const auto& [known, id] : names_)
            if (known.rfind(name + "(", 0) == 0) walk(id, result, 0);
        return result;
    }

  private:
    void walk(uint32_t function, std::vector<Step>& into, int depth) const {
        constexpr uint32_t of_buffers = 0x40;  // MemorySemantics UniformMemory
        const auto it = functions_.find(function);
        if (it == functions_.end() || depth > 8) return;
        for (const size_t at : it->second) {
            const uint32_t op = words_[at] & 0xffff;
            const auto semantics = [&](size_t word) {
                const auto constant = constants_.find(words_[at + word]);
                return constant == constants_.end() ? 0u : constant->second;
            };
            if (op >= 227 && op <= 242) into.push_back(Step::count);  // OpAtomic...
            if (op == 225 && semantics(2) & of_buffers) into.push_back(Step::memory_barrier);
            if (op == 224) {
                if (semantics(3) & of_buffers) into.push_back(Step::memory_barrier);
                into.push_back(Step::barrier);
            }
            if (op == 57) walk(words_[at + 3], into, depth + 1);  // OpFunctionCall
        }
    }

    const std::vector<uint32_t>& words_;
    std::map<std::string, uint32_t> names_;
    std::map<uint32_t, uint32_t> constants_;
    std::map<uint32_t, std::vector<size_t>> functions_;
};

// A driver that runs a workgroup's threads one after the other shows no missing barrier: the compiled code does.
void check_order(Check& check) {
    Owner owner;
    const MipChain chain(owner, "mips");
    const Pipeline pipeline = compute({.shader = "07_mipmaps/single_pass.comp"});
    const CompiledStages compiled = compile_stages(pipeline, flatten_stages(pipeline, chain.macros()));
    using Step = Order::Step;
    const std::vector<Step> steps = Order(compiled.spirv[0]).steps("is_last_workgroup");
    const auto count = std::find(steps.begin(), steps.end(), Step::count);
    const auto has = [](auto from, auto to, Step step) { return std::find(from, to, step) != to; };
    check.expect(count != steps.end(), "is_last_workgroup counts nothing: there is no atomic operation in it",
                 "atomicAdd(finished[layer], 1u), by one thread of the workgroup");
    if (count == steps.end()) return;
    check.expect(
        has(steps.begin(), count, Step::memory_barrier),
        "is_last_workgroup counts its workgroup without a memoryBarrierBuffer() before: others may see the count "
        "and not yet the result",
        "a write is seen by others in any order; memoryBarrierBuffer() asks for one");
    check.expect(
        has(count, steps.end(), Step::barrier),
        "is_last_workgroup has no barrier() after the count: the other threads may look into shared memory before "
        "the first one has written there",
        "barrier() waits for all threads of the workgroup");
    check.expect(
        has(count, steps.end(), Step::memory_barrier),
        "is_last_workgroup has no memoryBarrierBuffer() after the count: what the others have written may be read "
        "before it is there",
        "reads can come early, too: the second memoryBarrierBuffer() holds them back");
}

// Inputs of each thread of each workgroup, layer by layer, and the barriers it reached.
constexpr const char* harness = R"(
layout(local_size_x = 256) in;
#include "07_mipmaps/last_workgroup.glsl"
layout(scalar) writeonly buffer ToldBuffer { uint told[]; };
void main() {
    bool last = is_last_workgroup(int(gl_WorkGroupID.z), gl_NumWorkGroups.x * gl_NumWorkGroups.y);
    uint group = (gl_WorkGroupID.z * gl_NumWorkGroups.y + gl_WorkGroupID.y) * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    told[512u * group + gl_LocalInvocationIndex] = last ? 1u : 0u;
    told[512u * group + 256u + gl_LocalInvocationIndex] = check_barriers_passed;
}
)";

void count_last(Check& check, glm::uvec2 groups) {
    constexpr uint32_t layers = 3;
    const uint32_t of_layer = groups.x * groups.y;
    Gpu& gpu = check_device();
    const Pipeline pipeline = compute({.shader = "check of last_workgroup", .source = traced_barriers() + harness});
    const Buffer finished = gpu.upload("finished", std::vector<uint32_t>(layers, 0));
    std::vector<uint32_t> told(size_t(512) * of_layer * layers);
    const Buffer buffer(gpu.device, {.name = "told", .bytes = 4 * told.size()});
    Frame frame(gpu);
    frame.begin({4, 4}, 0);
    frame.compute("last", {.reads = {finished}, .writes = {finished, buffer}}, [&](Compute& pass) {
        pass.use(pipeline).set("told", buffer);
        pass.set_if_present("finished", finished);  // as handed out it is not asked for
        pass.dispatch({groups.x, groups.y, layers});
    });
    frame.end();
    std::memcpy(told.data(), gpu.read_back(buffer).data(), 4 * told.size());
    for (uint32_t layer = 0; layer < layers; ++layer) {
        uint32_t last = 0;
        for (uint32_t group = layer * of_layer; group < (layer + 1) * of_layer; ++group) {
            const std::span<const uint32_t> threads = std::span(told).subspan(size_t(512) * group, 256);
            const auto yes = std::count(threads.begin(), threads.end(), 1u);
            check.expect(
                yes == 0 || yes == 256,
                fmt::format("is_last_workgroup gave true to {} of a workgroup's 256 threads, expected all or none",
                            yes),
                "one thread's number reaches the others through shared memory, after a barrier()");
            const std::string wrong = barriers_wrong(std::span(told).subspan(size_t(512) * group + 256, 256));
            check.expect(wrong.empty(), "is_last_workgroup: " + wrong, barrier_hint);
            if (check.failed) return;
            last += yes == 256;
        }
        check.expect(last == 1,
                     fmt::format("of {} workgroups on layer {}, {} were told that they are the last, expected one",
                                 of_layer, layer, last),
                     "atomicAdd() returns the number before: the last one finds workgroups - 1, and nobody else does");
    }
}

}  // namespace

CHECK_EXERCISE(
    "07.last_workgroup",
    "One thread counts for its workgroup; the others receive the result through shared memory, after a barrier.") {
    compare(check, check_device(), {512, 384}, 1);
    compare(check, check_device(), {130, 257}, 3);
    check_order(check);
    if (check.failed) return;
    for (const glm::uvec2 groups : {glm::uvec2(1, 1), glm::uvec2(2, 1), glm::uvec2(3, 5)}) count_last(check, groups);
}
