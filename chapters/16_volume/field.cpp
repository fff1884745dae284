#include "16_volume/field.h"

#include <algorithm>

#include "16_volume/volume_file.h"
#include "common/base/exercise.h"

namespace lightwalk {

// What a scene shows whose volumes are all hidden.
static VolumeData empty_volume() {
    VolumeData data;
    data.size = glm::uvec3(2);
    data.spacing_m = glm::vec3(1);
    data.bytes.assign(8, std::byte(0));
    return data;
}

bool is_volume_file(const std::filesystem::path& file) { return file.extension() == ".volume"; }

void Field::prepare(Gpu& gpu, Scene& scene) {
    from_file_ = false;
    made_.forget();
    const auto& objects = scene.file.objects;
    if (std::none_of(objects.begin(), objects.end(), [](const auto& one) { return is_volume_file(one.model); })) return;
    from_file_ = true;
    ++number_;
    name_unused_placement(scene.file, is_volume_file, "a volume");
    const SceneObject* const shown = first_shown(scene.file, is_volume_file);
    const VolumeData data = shown ? read_volume(find_asset(shown->model)) : empty_volume();
    density_ = Image(gpu.device, {.name = path() + " density",
                                  .format = data.is_half ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R8_UNORM,
                                  .size = {data.size.x, data.size.y},
                                  .depth = data.size.z});
    gpu.upload(density_, data.bytes);
    const glm::vec3 extent = glm::vec3(data.size) * data.spacing_m;
    half_m_ = extent / std::max({extent.x, extent.y, extent.z});
}

void Field::record(Frame& frame) {
    if (from_file_ || made_.is_current(epoch())) return;
    half_m_ = glm::vec3(1.0f);
    ++number_;
    const auto edge = static_cast<uint32_t>(voxels);
    density_ = Image(frame.gpu.device, {.name = path() + " density",
                                        .format = VK_FORMAT_R16_SFLOAT,
                                        .size = {edge, edge},
                                        .depth = edge,
                                        .kept = true});
    frame.compute("nebula", {.writes = {density_}, .with = {*this}},
                  [&](Compute& pass) { pass.use(nebula_).set("result", density_).dispatch_threads(glm::uvec3(edge)); });
}

// [record]
void BlockPyramid::record(Frame& frame, const Field& field, const Image& transfer, uint64_t transfer_number,
                          int border) {
    if (made_.is_current(field.number(), transfer_number, border, Exercises::epoch())) return;
    const glm::uvec3 voxels = ImageView(field.density()).size();
    const glm::uvec3 blocks = (voxels + static_cast<uint32_t>(BLOCK_VOXELS - 1)) / static_cast<uint32_t>(BLOCK_VOXELS);
    ranges_.ensure(frame.gpu.device, {.name = "block ranges",
                                      .format = VK_FORMAT_R16G16_SFLOAT,
                                      .size = {blocks.x, blocks.y},
                                      .depth = blocks.z,
                                      .kept = true});
    // Whole blocks of the coarsest level.
    const uint32_t most = 1u << (BLOCK_LEVELS - 1);
    const glm::uvec3 edges = (blocks + most - 1u) / most * most;
    for (Image* image : {&occupied_, &blocks_})
        image->ensure(frame.gpu.device, {.name = image == &blocks_ ? "empty blocks" : "occupied blocks",
                                         .format = VK_FORMAT_R8_UNORM,
                                         .size = {edges.x, edges.y},
                                         .depth = edges.z,
                                         .kept = true});
    frame.compute("block ranges", {.reads = {field.density()}, .writes = {ranges_}}, [&](Compute& pass) {
        pass.use(find_).set("voxels", field.density(), nearest_clamp).set("ranges", ranges_).set("border", border);
        pass.dispatch(blocks);
    });
    frame.compute("occupied blocks", {.reads = {ranges_, transfer}, .writes = {occupied_}}, [&](Compute& pass) {
        pass.use(occupy_).set("ranges", ranges_, nearest_clamp).set("volume_transfer", transfer, nearest_clamp);
        pass.set("result", occupied_).dispatch_threads(edges);
    });
    frame.compute("empty blocks", {.reads = {occupied_}, .writes = {blocks_}}, [&](Compute& pass) {
        pass.use(coarser_).set("occupied", occupied_, nearest_clamp).set("result", blocks_).dispatch_threads(edges);
    });
}
// [/record]

}  // namespace lightwalk
