// A pass's control over the draws of others: their blending, and the file that ends their shaders.
#include "common/gpu/glsl.h"
#include "gpu_fixture.h"

using namespace lightwalk;

TEST_CASE_METHOD(OnDevice, "a pass's mixing overrules the blending and the depth writing of its pipelines") {
    const Image color = image({.name = "color", .format = four_floats, .size = {4, 4}});
    const Image depth = image({.name = "depth", .format = VK_FORMAT_D32_SFLOAT, .size = {4, 4}});
    const Pipeline opaque = quad_pipeline({.depth_write = false});
    const auto drawn = [&](std::optional<BlendOverride> blend_override) {
        frame.raster("draw",
                     {.color = {clear(color, glm::vec4(0))},
                      .depth = clear(depth, 0.25f),
                      .blend_override = std::move(blend_override)},
                     [&](Raster& pass) {
                         pass.use(opaque).set("quad", Quad{}).set("paint", Paint{.first = glm::vec4(0.25f)});
                         pass.draw(6).draw(6);
                     });
        frame.end();
        const std::pair result(value(color), read<float>(depth)[0]);
        frame.begin({4, 4}, 0);
        return result;
    };
    CHECK(drawn({}) == std::pair(0.25f, 0.25f));
    CHECK(drawn(BlendOverride{{Blend::add}, false}) == std::pair(0.5f, 0.25f));
    CHECK(drawn(BlendOverride{{Blend::opaque}, true}) == std::pair(0.25f, 0.5f));
    CHECK(drawn({}) == std::pair(0.25f, 0.25f));
}

TEST_CASE("a replaced file is read in place of the one that is included, of a later chapter too") {
    const std::string text = "#include \"common/put_surface.glsl\"\nvoid main() { put_surface(vec3(0.0), 1.0); }\n";
    const FlatShader plain = flatten_text(text, "test", "01", {});
    CHECK(plain.text.find("layout(location = 0) out vec4 color;") != plain.text.npos);
    const Macros macros = Macros().replace_file("common/put_surface.glsl", "common/srgb.glsl");
    const FlatShader other = flatten_text(text, "test", "01", macros);
    CHECK(other.text.find("out vec4 color") == other.text.npos);
    REQUIRE(other.files.size() == 1);
    CHECK(other.files[0].filename() == "srgb.glsl");
}
