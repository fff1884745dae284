// Height maps of other people: tiles of the Shuttle Radar Topography Mission.
#include <unistd.h>

#include "15_terrain_water/height_map.h"
#include "catch.h"
#include "common/base/error.h"
#include "common/base/files.h"

using namespace lightwalk;

// USGS, "SRTM Topography": 16-bit signed integers, big endian, rows from north to south, -32768 where there is no data; the
// name is that of the south-western corner. A degree of longitude at 46.5 N is cos(46.5) = 0.68835 of one at the equator.
TEST_CASE("hgt: a tile of three by three samples") {
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("lightwalk_hgt_{}", getpid());
    std::filesystem::create_directories(folder);
    const std::string bytes("\x11\x94\x00\x01\xff\xfe\x80\x00\x00\x05\x00\x06\x00\x07\x00\x08\x00\x09", 18);
    write_file(folder / "N46E007.hgt", bytes);
    const HeightMap map = read_height_map(folder / "N46E007.hgt");
    CHECK((map.width == 3 && map.height == 3));
    CHECK(map.elevation_m == std::vector<float>{4500, 1, -2, -2, 5, 6, 7, 8, 9});
    CHECK(std::abs(map.sample_m.y - 55660) < 1);  // half of 60 nautical miles of 1,855.3 m
    CHECK(std::abs(map.sample_m.x / map.sample_m.y - 0.68835f) < 1e-4f);
    write_file(folder / "S34W070.hgt", bytes);
    CHECK(std::abs(read_height_map(folder / "S34W070.hgt").sample_m.x / 55660 - 0.83389f) < 1e-4f);  // cos(33.5)
    write_file(folder / "tile.json", R"({"metres_per_sample_x": 90, "metres_per_sample_y": 91})");
    write_file(folder / "tile.hgt", bytes);
    CHECK(read_height_map(folder / "tile.hgt").sample_m == glm::vec2(90, 91));
    write_file(folder / "cut.hgt", bytes.substr(0, 17));
    CHECK_THROWS_AS(read_height_map(folder / "cut.hgt"), InputError);
    std::filesystem::remove_all(folder);
}
