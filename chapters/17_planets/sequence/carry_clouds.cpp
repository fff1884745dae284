// Frames of Jupiter's clouds, by hand: ninja -C build carry_clouds && build/carry_clouds assets/planets_2k (a minute).
//
// Writes jupiter_1.jpg to jupiter_4.jpg: the map, carried by the winds of shaders/17_planets/flow.glsl for so many days.
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

#include <cstdio>
#include <exception>

#include "17_planets/planets.h"
#include "common/app/read_picture.h"
#include "common/base/error.h"
#include "common/scene/asset_path.h"

using namespace lightwalk;

namespace {

constexpr int jpeg_quality = 80;

struct Winds : Module {
    Planets planets{*this, "planets"};
    Pipeline carry = compute({.shader = "17_planets/carry_clouds.comp"});

    Winds() {
        planets.flow.set("advected");
        planets.flow_frames.set("five");
    }

    void write_frames(const std::string& folder) {
        Gpu gpu(DeviceOptions{});
        ImagePool pool(gpu);
        Frame frame(gpu);
        const auto map = pool.load(find_asset(traits(BodyId::jupiter).map), TextureKind::color);
        const glm::uvec2 size(map->desc.size);
        for (int day = 1; day <= sequence_days; ++day) {
            frame.begin(size, 0);
            frame.compute("carry", {.reads = {*map}, .writes = {frame.hdr}, .with = {planets}}, [&](Compute& pass) {
                pass.use(carry).set("result", frame.hdr).set("days", static_cast<float>(day));
                pass.set("body_map", *map, Sampler{.wrap = Wrap::repeat}).dispatch_threads(size);
            });
            frame.end();
            const Image8 codes = to_srgb8(read_linear(gpu, frame.hdr));
            const std::string file = fmt::format("{}/jupiter_{}.jpg", folder, day);
            if (!stbi_write_jpg(file.c_str(), codes.width, codes.height, 4, codes.pixels.data(), jpeg_quality))
                throw InputError("{}: cannot be written", file);
        }
    }
};

}  // namespace

int main(int count, char** words) try {
    if (count != 2) {
        std::fputs("usage: carry_clouds FOLDER\n", stderr);
        return 2;
    }
    Winds().write_frames(words[1]);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
}
