#include <bit>
#include <cstring>

#include "common/app/chapter.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

// A block called `knobs` gets, member by member, the knob of that name.
std::vector<std::byte> knob_block(const KnobList& knobs, const Binding& binding) {
    if (binding.name != "knobs") return {};
    std::vector<std::byte> bytes(binding.bytes);
    for (const BlockMember& member : binding.members) {
        const std::vector<float> numbers = find_knob(knobs, member.name).numbers();
        if (numbers.size() != member.components)
            throw Failure("the shader's knobs." + member.name + " has " + std::to_string(member.components) +
                          " components, the knob " + std::to_string(numbers.size()));
        for (size_t i = 0; i < numbers.size(); ++i) {
            const uint32_t word = member.type == BlockMember::Type::number
                                      ? std::bit_cast<uint32_t>(numbers[i])
                                      : std::bit_cast<uint32_t>(static_cast<int32_t>(numbers[i]));
            std::memcpy(bytes.data() + member.offset + 4 * i, &word, 4);
        }
    }
    return bytes;
}

const Pipeline encode = compute({.shader = "common/encode_srgb.comp", .defines = {}, .source = {}});

}  // namespace

Chapter::~Chapter() {
    // A chapter made after this one may be gone already, or still register its knobs with itself.
    if (knobs_under_construction() == &knobs) knobs_under_construction() = nullptr;
}

std::vector<std::string> load_scene(Chapter& chapter, Gpu& gpu, const std::filesystem::path& given,
                                    std::optional<double> budget, glm::uvec2 size) {
    const auto loader = [&](const std::filesystem::path& file) { return chapter.load_model(file); };
    const std::filesystem::path file = find_asset(given);
    const bool is_scene = file.extension() == ".json";
    SceneFile scene = is_scene ? read_scene(file) : scene_of_model(file, {});
    for (const auto& [name, value] : scene.knobs)
        if (KnobBase& knob = find_knob(chapter.knobs, name); !knob.pinned) knob.set(value);
    std::vector<std::string> explanation;
    const auto choose = [&](std::vector<std::string> lines) {
        explanation.insert(explanation.end(), lines.begin(), lines.end());
    };
    chapter.scene.file = scene;
    if (budget) choose(chapter.choose_before_loading(*budget));
    chapter.scene.load(gpu, std::move(scene), loader);
    // A bare model: now that its size is known, a camera that frames it. The pool keeps the model.
    if (!is_scene) chapter.scene.load(gpu, scene_of_model(file, chapter.scene.bounds), loader);
    chapter.camera = chapter.scene.file.camera;
    chapter.prepare(gpu);
    if (budget) choose(chapter.choose(*budget, size));
    if (budget && explanation.empty()) throw InputError("chapter " + chapter.name + " has no rule for auto");
    return explanation;
}

void record(Chapter& chapter, Frame& frame, glm::uvec2 size, float time_s, unsigned seed) {
    Defines defines;
    for (const KnobBase* knob : chapter.knobs)
        for (const auto& [name, value] : knob->macros()) defines[name] = value;
    frame.gpu.pipelines.defines = std::move(defines);
    frame.fill_block = [&chapter](const Binding& binding) { return knob_block(chapter.knobs, binding); };
    frame.begin(size, time_s);
    frame.seed = seed;
    chapter.frame(frame);
}

void render(Chapter& chapter, Frame& frame, glm::uvec2 size, float time_s, unsigned seed) {
    record(chapter, frame, size, time_s, seed);
    frame.end();
}

void encode_srgb(Frame& frame) {
    frame.compute("encode_srgb", {.reads = {frame.hdr}, .writes = {frame.output}}, [&](Compute& pass) {
        pass.use(encode).set("hdr", frame.hdr, nearest_clamp).set("result", frame.output);
        pass.dispatch_threads(frame.size);
    });
}

}  // namespace lightwalk
