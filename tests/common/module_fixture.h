// Shared by the tests of a chapter's modules: their owner and a device, and frames that filter a picture made from numbers.
#pragma once
#include <glm/gtc/packing.hpp>

#include "common/app/drawing.h"
#include "common/app/module.h"
#include "common/app/read_picture.h"
#include "gpu_fixture.h"

namespace lightwalk {

/// Owner of a test's modules.
struct NoChapter : Module {};

/// Base for TEST_CASE_METHOD: modules are members with `owner` as their owner. No frame is begun.
struct OnModules : DeviceTest {
    NoChapter owner;

    void begin(glm::uvec2 size, float time_s = 0) {
        owner.begin_frame(gpu, size);
        frame.begin(size, time_s);
    }

    /// A frame of the view's size that shows the drawing before `background`; the picture is frame.hdr.
    void draw_frame(const View& view, Drawing& drawing, float time_s = 0, glm::vec4 background = glm::vec4(0)) {
        begin(view.size, time_s);
        Canvas canvas(frame.hdr, frame.depth, background);
        lightwalk::draw(frame, view, canvas, {drawing});
        frame.end();
    }

    /// A picture of light(x, y), which is a number or a vec3, as texels of four half floats.
    template <class Light>
    static std::vector<uint64_t> half_texels(glm::uvec2 size, const Light& light, float alpha) {
        std::vector<uint64_t> texels;
        for (uint32_t y = 0; y < size.y; ++y)
            for (uint32_t x = 0; x < size.x; ++x)
                texels.push_back(glm::packHalf4x16(glm::vec4(glm::vec3(light(int(x), int(y))), alpha)));
        return texels;
    }

    /// A frame in which `image` gets these texels, then record() is called.
    template <class Record>
    void filter_frame(Image& image, glm::uvec2 size, const std::vector<uint64_t>& texels, const Record& record,
                      float time_s = 0) {
        image.ensure(gpu.device, {.name = "picture", .size = size});
        begin({4, 4}, time_s);
        frame.upload("picture", image, std::as_bytes(std::span(texels)));
        record();
        frame.end();
    }
};

}  // namespace lightwalk
