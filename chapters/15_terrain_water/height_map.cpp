#include "15_terrain_water/height_map.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>
#include <nlohmann/json.hpp>

#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/text.h"
#include "common/image/decode.h"

namespace lightwalk {
namespace {

using Json = nlohmann::json;

/// Contents of a .json beside the picture.
struct Scale {
    double low_m = 0, high_m = 1000, x_m = 30, y_m = 30;
};

void read_number(const std::filesystem::path& file, const Json& json, const char* key, double least, double most,
                 double& value) {
    if (!json.contains(key)) return;
    const Json& found = json.at(key);
    if (!found.is_number() || !(found.get<double>() >= least && found.get<double>() <= most))
        throw InputError("{}: key '{}' must be a number from {:g} to {:g}", file.string(), key, least, most);
    value = found.get<double>();
}

// `scale`: where the .json says nothing.
Scale read_scale(std::filesystem::path file, Scale scale = {}) {
    file.replace_extension(".json");
    if (!std::filesystem::exists(file)) return scale;
    const Json json = Json::parse(read_file(file, size_t{1} << 20), nullptr, false);
    if (!json.is_object()) throw InputError("{}: not a JSON object", file.string());
    read_number(file, json, "min_elevation_m", -12000, 10000, scale.low_m);
    read_number(file, json, "max_elevation_m", -12000, 10000, scale.high_m);
    read_number(file, json, "metres_per_sample_x", 1e-3, 1e5, scale.x_m);
    read_number(file, json, "metres_per_sample_y", 1e-3, 1e5, scale.y_m);
    if (scale.high_m < scale.low_m)
        throw InputError("{}: key 'max_elevation_m' must not be below min_elevation_m", file.string());
    return scale;
}

bool is_hgt(const std::filesystem::path& file) { return file.extension() == ".hgt" || file.extension() == ".HGT"; }

// N46E007: degrees of the south-western corner; 0 where the name says nothing.
double latitude_of(const std::string& name) {
    const bool says = name.size() >= 3 && std::string_view("NSns").find(name[0]) != std::string_view::npos &&
                      std::isdigit(static_cast<unsigned char>(name[1])) &&
                      std::isdigit(static_cast<unsigned char>(name[2]));
    if (!says) return 0;
    const double degrees = 10 * (name[1] - '0') + (name[2] - '0');
    return std::toupper(name[0]) == 'S' ? -degrees : degrees;
}

// A tile of the Shuttle Radar Topography Mission: one degree as a square of big-endian metres, rows from the north.
HeightMap read_hgt(const std::filesystem::path& file) {
    constexpr int16_t no_data = -32768;
    constexpr double degree_m = 111320;  // of latitude, and of longitude at the equator
    const std::string bytes = read_file(file);
    const auto side = static_cast<size_t>(std::lround(std::sqrt(double(bytes.size()) / 2)));
    if (side < 2 || 2 * side * side != bytes.size())
        throw InputError("{}: {} bytes, expected a square of elevations of two bytes each", file.string(),
                         bytes.size());
    const double sample_m = degree_m / double(side - 1);
    const double middle_rad = (latitude_of(file.filename().string()) + 0.5) * glm::pi<double>() / 180;
    const Scale scale = read_scale(file, {.x_m = sample_m * std::cos(middle_rad), .y_m = sample_m});
    HeightMap map{
        .width = int(side), .height = int(side), .sample_m = glm::vec2(scale.x_m, scale.y_m), .elevation_m = {}};
    size_t voids = 0;
    float last = 0;
    for (size_t i = 0; i < side * side; ++i) {
        const auto high = static_cast<unsigned char>(bytes[2 * i]), low = static_cast<unsigned char>(bytes[2 * i + 1]);
        const auto elevation = static_cast<int16_t>(high << 8 | low);
        voids += elevation == no_data;
        if (elevation != no_data) last = elevation;
        map.elevation_m.push_back(last);
    }
    if (voids > 0) warn("{}: {} samples without data have the elevation before them", file.string(), voids);
    return map;
}

}  // namespace

bool is_height_map_file(const std::filesystem::path& file) { return file.extension() == ".png" || is_hgt(file); }

HeightMap read_height_map(const std::filesystem::path& file) {
    if (is_hgt(file)) return read_hgt(file);
    const Decoded picture = decode_picture(file, 3, Depth::as_stored);
    if (picture.channels > 2)
        throw InputError("{}: {} channels; a height map is a grey picture with 1", file.string(), picture.channels);
    if (picture.width < 2 || picture.height < 2)
        throw InputError("{}: {}x{} samples; a height map has at least 2x2", file.string(), picture.width,
                         picture.height);
    const Scale scale = read_scale(file);
    HeightMap map{.width = picture.width,
                  .height = picture.height,
                  .sample_m = glm::vec2(scale.x_m, scale.y_m),
                  .elevation_m = {}};
    const size_t count = size_t(picture.width) * size_t(picture.height);
    map.elevation_m.resize(count);
    for (size_t i = 0; i < count; ++i) {
        double share = 0;
        if (picture.bits == 16) {
            uint16_t code = 0;
            std::memcpy(&code, picture.samples.data() + 6 * i, 2);
            share = code / 65535.0;
        } else {
            share = static_cast<uint8_t>(picture.samples[3 * i]) / 255.0;
        }
        map.elevation_m[i] = static_cast<float>(scale.low_m + share * (scale.high_m - scale.low_m));
    }
    return map;
}

}  // namespace lightwalk
