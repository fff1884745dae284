#include "16_volume/volume_file.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"

namespace lightwalk {
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
