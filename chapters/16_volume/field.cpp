#include "16_volume/field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"

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

namespace {

using Json = nlohmann::json;

// Three numbers of a key. Throws InputError.
glm::dvec3 three_numbers(const std::string& where, const Json& header, const char* key, double least, double most) {
    const Json& value = header.at(key);
    glm::dvec3 numbers;
    bool right = value.is_array() && value.size() == 3;
    for (int i = 0; right && i < 3; ++i) {
        right = value[static_cast<size_t>(i)].is_number();
        if (right) numbers[i] = value[static_cast<size_t>(i)].get<double>();
        right = right && numbers[i] >= least && numbers[i] <= most;
    }
    if (!right) throw InputError("{}: key '{}' must be three numbers from {:g} to {:g}", where, key, least, most);
    return numbers;
}

std::string text_of(const std::string& where, const Json& header, const char* key) {
    if (!header.contains(key) || !header.at(key).is_string())
        throw InputError("{}: key '{}' must be a text", where, key);
    return header.at(key).get<std::string>();
}

std::vector<std::byte> as_halves(const std::string& numbers) {
    std::vector<std::byte> bytes(numbers.size() / 2);
    for (size_t i = 0; i < numbers.size() / 4; ++i) {
        float value = 0;
        std::memcpy(&value, numbers.data() + 4 * i, 4);
        const uint16_t half = glm::packHalf1x16(value);
        std::memcpy(bytes.data() + 2 * i, &half, 2);
    }
    return bytes;
}

}  // namespace

VolumeData read_volume(const std::filesystem::path& file) {
    const std::string where = file.string();
    const Json header = Json::parse(read_file(file, size_t{1} << 20), nullptr, false);
    if (!header.is_object())
        throw InputError(
            "{}: not a volume: expected JSON such as {{\"file\": \"head.raw\", \"dims\": [128, 128, 128], "
            "\"dtype\": \"uint8\"}}",
            where);
    if (!header.contains("dims")) throw InputError("{}: key 'dims' is missing: voxels along x, y and z", where);
    const glm::dvec3 dims = three_numbers(where, header, "dims", 1, 512);
    VolumeData volume;
    volume.size = glm::uvec3(dims);
    if (glm::dvec3(volume.size) != dims) throw InputError("{}: key 'dims' must be integers", where);
    if (header.contains("spacing_mm"))
        volume.spacing_m = glm::vec3(three_numbers(where, header, "spacing_mm", 1e-3, 1e3) / 1000.0);
    const std::string type = text_of(where, header, "dtype");
    if (type != "uint8" && type != "float32")
        throw InputError("{}: key 'dtype': unknown type '{}'; use \"uint8\" or \"float32\"", where, type);
    volume.is_half = type == "float32";
    const std::filesystem::path beside = text_of(where, header, "file");
    if (beside.has_parent_path() || beside.empty())
        throw InputError("{}: key 'file' must name a file in the same folder, without a path", where);
    const size_t expected =
        size_t{volume.size.x} * volume.size.y * volume.size.z * (volume.is_half ? sizeof(float) : 1u);
    const InputFile there(file.parent_path() / beside);
    if (there.bytes != expected)
        throw InputError("{}: {} has {} bytes, but {} x {} x {} voxels of {} need {}", where, beside.string(),
                         there.bytes, volume.size.x, volume.size.y, volume.size.z, type, expected);
    const std::string numbers = read_file(file.parent_path() / beside);
    if (numbers.size() != expected) throw InputError("{}: {} changed while it was read", where, beside.string());
    if (volume.is_half) {
        volume.bytes = as_halves(numbers);
    } else {
        volume.bytes.resize(numbers.size());
        std::memcpy(volume.bytes.data(), numbers.data(), numbers.size());
    }
    return volume;
}

}  // namespace lightwalk
