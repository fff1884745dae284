// Views: a layer, a mip, a face, a slice wherever an image goes, each with its own barriers; samplers.
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

// One texel a group, from `source` to `result`, for any sizes.
const Pipeline halve = compute_pipeline("halve", R"(
layout(local_size_x = 1, local_size_y = 1) in;
uniform sampler2D source;
layout(r32f) writeonly uniform image2D result;
void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += texelFetch(source, 2 * at + ivec2(i & 1, i >> 1), 0).r;
    imageStore(result, at, vec4(sum + 1.0));
}
)");

Access write_in_compute() {
    return {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, true};
}
Access read_in_compute() {
    return {VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_READ_BIT,
            VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, false};
}

}  // namespace

TEST_CASE_METHOD(OnDevice, "a mip of a layer is cleared and read back alone") {
    const Image map = image({.format = one_float, .size = {8, 4}, .mips = 3, .layers = 4});
    for (uint32_t layer = 0; layer < 4; ++layer)
        for (uint32_t mip = 0; mip < 3; ++mip)
            frame.raster("clear", {.color = {clear(map.layer(layer).mip(mip), glm::vec4(float(10 * layer + mip)))}},
                         [](Raster&) {});
    frame.raster("again", {.color = {clear(map.mip(1).layer(3), glm::vec4(99.0f))}}, [](Raster&) {});
    frame.end();
    for (uint32_t layer = 0; layer < 4; ++layer)
        for (uint32_t mip = 0; mip < 3; ++mip)
            CHECK(value(map.layer(layer).mip(mip)) == (layer == 3 && mip == 1 ? 99.0f : float(10 * layer + mip)));
    CHECK(read<float>(map.mip(2)).size() == 2 * 1 * 4);
    CHECK(read<float>(map.layer_range(1, 2).mip(1)) ==
          std::vector<float>{11, 11, 11, 11, 11, 11, 11, 11, 21, 21, 21, 21, 21, 21, 21, 21});
    CHECK(failure_of([&] { map.layer(4); }) == "test has no layers 4 to 4");
    CHECK(failure_of([&] { map.layer(2).mip(3); }) == "test layer 2 has no mip 3");
}

TEST_CASE_METHOD(OnDevice, "one compute pass makes the whole chain, waiting between dispatches, and is timed once") {
    const Image chain = image({.format = one_float, .size = {64, 64}, .mips = 7});
    frame.raster("first", {.color = {clear(chain.mip(0), glm::vec4(1.0f))}}, [](Raster&) {});
    frame.compute("chain", {.reads = {chain}, .writes = {chain}}, [&](Compute& pass) {
        for (uint32_t m = 1; m < 7; ++m) {
            pass.use(halve).set("source", chain.mip(m - 1), nearest_clamp).set("result", chain.mip(m));
            pass.dispatch_threads(glm::uvec2(chain.mip(m).size())).wait();
        }
    });
    frame.end();
    CHECK(value(chain.mip(6)) == 5461.0f);  // 4 x + 1, six times
    REQUIRE(frame.times.size() == 2);
    CHECK(frame.times[1].name == "chain");
}

TEST_CASE_METHOD(OnDevice, "a raster pass draws into a mip and samples another of the same image") {
    const Image chain = image({.format = four_floats, .size = {4, 4}, .mips = 3});
    const Pipeline twice = quad_pipeline({}, "twice.frag");
    frame.raster("first", {.color = {clear(chain.mip(0), glm::vec4(3.0f))}}, [](Raster&) {});
    for (uint32_t m = 1; m < 3; ++m)
        frame.raster("twice", {.color = {discard(chain.mip(m))}, .reads = {chain.mip(m - 1)}}, [&](Raster& pass) {
            pass.use(twice).set("quad", Quad{}).set("source", chain.mip(m - 1)).draw(6);
        });
    frame.end();
    CHECK(value(chain.mip(2)) == 12.0f);
}

TEST_CASE_METHOD(OnDevice, "barriers are per mip and layer, and one where all are alike") {
    const Image map = image({.format = one_float, .size = {8, 8}, .mips = 4, .layers = 3});
    Barriers barriers;
    const auto added = [&](const ImageView& view, const Access& next) {
        barriers.images.clear();
        barriers.add(view, next);
        return barriers.images.size();
    };
    CHECK(added(map, write_in_compute()) == 1);
    CHECK(barriers.images[0].subresourceRange.levelCount == 4);
    CHECK(barriers.images[0].subresourceRange.layerCount == 3);
    CHECK(added(map.mip(0), read_in_compute()) == 1);
    CHECK(barriers.images[0].subresourceRange.levelCount == 1);
    CHECK(barriers.images[0].oldLayout == VK_IMAGE_LAYOUT_GENERAL);
    CHECK(added(map.layer(1).mip(0), read_in_compute()) == 0);  // read already
    CHECK(added(map.layer(2).mip(3), read_in_compute()) == 1);
    CHECK(map.history.each.size() == 12);
    CHECK(added(map, read_in_compute()) == 2);  // mips 1 and 2, and two layers of mip 3
    CHECK(map.history.each.empty());
    CHECK(added(map.layer(1), read_in_compute()) == 0);
    CHECK(map.history.each.empty());  // a read of a part that changes nothing keeps all in one
    CHECK(added(map, write_in_compute()) == 1);
    CHECK(barriers.images[0].srcAccessMask == VK_ACCESS_2_NONE);  // only readers to wait for
    for (uint32_t m = 0; m < 4; ++m) CHECK(added(map.mip(m), write_in_compute()) == 1);
    CHECK(map.history.each.empty());

    const Buffer buffer(gpu.device, {.name = "test", .bytes = 64});
    barriers.add(buffer, write_in_compute());
    CHECK(barriers.buffers.empty());
    barriers.add(buffer, read_in_compute());
    barriers.add(buffer, read_in_compute());
    CHECK(barriers.buffers.size() == 1);
    barriers.images.clear();
    barriers.buffers.clear();
}

TEST_CASE_METHOD(OnDevice, "parts of an image that overlap are used in one way only") {
    const Image chain = image({.format = one_float, .size = {8, 8}, .mips = 4});
    const Image other = image({.name = "other", .format = one_float, .size = {8, 8}});
    CHECK(failure_of([&] { frame.compute("x", {.reads = {chain}, .writes = {chain.mip(1)}}, [](Compute&) {}); }) ==
          "pass 'x' uses test mip 1 and test, which overlap, in different ways; state mips or layers apart");
    CHECK(failure_of([&] { frame.raster("x", {.color = {chain}, .reads = {chain.mip(0)}}, [](Raster&) {}); }) ==
          "pass 'x' uses test mip 0 and test, which overlap, in different ways; state mips or layers apart");
    frame.raster("write", {.color = {chain.mip(1)}}, [](Raster&) {});
    CHECK(failure_of([&] {
              frame.compute("x", {.reads = {chain.mip(1)}, .writes = {other}},
                            [&](Compute& pass) { pass.use(halve).set("source", chain.mip(0)); });
          }) == "pass 'x' binds 'source' without stating it in its reads");
    CHECK(failure_of([&] { frame.compute("x", {}, [&](Compute&) { frame.compute("y", {}, [](Compute&) {}); }); }) ==
          "pass 'y' begins within pass 'x'");
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "a volume is written slice by slice, sampled between slices, and drawn into") {
    const Image volume = image({.format = one_float, .size = {4, 2}, .depth = 8});
    const Buffer seen(gpu.device, {.name = "seen", .bytes = 16});
    const Pipeline fill = compute_pipeline("fill", R"(
layout(local_size_x = 1) in;
layout(r32f) writeonly uniform image3D volume;
void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    imageStore(volume, at, vec4(at.x + 10 * at.y + 100 * at.z));
}
)");
    const Pipeline look = compute_pipeline("look", R"(
layout(local_size_x = 1) in;
uniform sampler3D volume;
layout(scalar) buffer SeenBuffer { float seen[]; };
void main() {
    seen[0] = textureLod(volume, vec3(1.5 / 4.0, 0.5 / 2.0, 4.0 / 8.0), 0.0).r;  // between slices 3 and 4
    seen[1] = texelFetch(volume, ivec3(3, 1, 7), 0).r;
    seen[2] = texelFetch(volume, ivec3(0, 0, 5), 0).r;
}
)");
    frame.compute("fill", {.writes = {volume}}, [&](Compute& pass) {
        pass.use(fill).set("volume", volume).dispatch({4, 2, 8});
    });
    frame.raster("slice", {.color = {clear(volume.layer(5), glm::vec4(-7.0f))}}, [](Raster&) {});
    frame.compute("look", {.reads = {volume}, .writes = {seen}}, [&](Compute& pass) {
        pass.use(look);
        CHECK(failure_of([&] { pass.set("volume", volume.layer(1)); }) ==
              "pass 'look': 'volume' is 3-D in the shader, and test slice 1 is a slice, which can be drawn into alone");
        pass.use(look).set("volume", volume, linear_clamp).set("seen", seen).dispatch({1, 1, 1});
    });
    frame.end();
    const auto values = read<float>(seen);
    CHECK(values[0] == 351.0f);  // between 301 and 401
    CHECK(values[1] == 713.0f);
    CHECK(values[2] == -7.0f);
    const auto texels = read<float>(volume);
    REQUIRE(texels.size() == 64);
    CHECK(texels[8 * 6 + 4 + 2] == 612.0f);
}

TEST_CASE_METHOD(OnDevice, "a cube is drawn face by face, and bound as the shader wants it") {
    const Image cube = image({.format = one_float, .size = {4, 4}, .mips = 2, .layers = 6, .cube = true});
    const Buffer seen(gpu.device, {.name = "seen", .bytes = 32});
    const Pipeline look = compute_pipeline("look at a cube", R"(
layout(local_size_x = 1) in;
uniform samplerCube cube;
uniform sampler2DArray faces;
uniform sampler2D face;
layout(scalar) buffer SeenBuffer { float seen[]; };
void main() {
    seen[0] = textureLod(cube, vec3(0, -1, 0), 1.0).r;
    seen[1] = textureLod(cube, vec3(1, 0, 0), 0.0).r;
    seen[2] = texelFetch(faces, ivec3(0, 0, 5), 1).r;
    seen[3] = texelFetch(face, ivec2(0), 0).r;
}
)");
    for (uint32_t f = 0; f < 6; ++f)
        for (uint32_t m = 0; m < 2; ++m)
            frame.raster("face", {.color = {clear(cube.face(f).mip(m), glm::vec4(float(1 + f + 10 * m)))}},
                         [](Raster&) {});
    frame.compute("look", {.reads = {cube}, .writes = {seen}}, [&](Compute& pass) {
        pass.use(look).set("cube", cube).set("faces", cube).set("face", cube.face(2).mip(1)).set("seen", seen);
        pass.dispatch({1, 1, 1});
        CHECK(failure_of([&] { pass.set("face", cube); }) ==
              "pass 'look': 'face' is 2-D in the shader, and test is cube");
        CHECK(failure_of([&] { pass.set("cube", cube.layer_range(0, 5)); }) ==
              "pass 'look': 'cube' is cube in the shader, and test layers 0 to 4 is 2-D array");
        pass.set("face", cube.layer_range(2, 1).mip(1)).set("cube", cube.as_array()).dispatch({1, 1, 1});
    });
    frame.end();
    const auto values = read<float>(seen);
    CHECK(values[0] == 14.0f);
    CHECK(values[1] == 1.0f);
    CHECK(values[2] == 16.0f);
    CHECK(values[3] == 13.0f);
}

TEST_CASE_METHOD(OnDevice, "a geometry shader draws into several layers at once") {
    const Image map = image({.format = VK_FORMAT_D32_SFLOAT, .size = {4, 4}, .layers = 5});
    Pipeline::Graphics states{.geometry = test_shader("layer.geom"), .cull = VK_CULL_MODE_NONE};
    states.vertex = test_shader("quad.vert");
    const Pipeline layers = graphics(states);
    frame.raster("all", {.depth = clear(map, 0.25f), .layers = 5}, [](Raster&) {});
    frame.raster("three", {.depth = keep(map.layer_range(1, 3)), .layers = 3}, [&](Raster& pass) {
        pass.use(layers).set("quad", Quad{.depth = 0.75f, .depth_right = 0.75f}).draw(6, 2, 1);
    });
    frame.end();
    const float expected[] = {0.25f, 0.25f, 0.75f, 0.75f, 0.25f};
    for (uint32_t i = 0; i < 5; ++i) CHECK(value(map.layer(i)) == expected[i]);
}

TEST_CASE_METHOD(OnDevice, "what was uploaded may be copied from, and read again by a pass that does not say so") {
    Image source = image({.format = one_float, .size = {2, 2}});
    const std::vector<float> texels{1, 2, 3, 4};
    gpu.upload(source, std::as_bytes(std::span(texels)));
    const Image copy = image({.name = "copy", .format = one_float, .size = {2, 2}});
    const Image sum = image({.name = "sum", .format = one_float, .size = {1, 1}});
    frame.transfer("copy", {.reads = {source}, .writes = {copy}}, [&](VkCommandBuffer commands) {
        const VkImageCopy all{.srcSubresource = ImageView(source).first_mip_layers(),
                              .dstSubresource = ImageView(copy).first_mip_layers(),
                              .extent = {2, 2, 1}};
        vkCmdCopyImage(commands, source.handle, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, copy.handle,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &all);
    });
    frame.compute("sum", {.writes = {sum}}, [&](Compute& pass) {
        pass.use(halve).set("source", source).set("result", sum).dispatch({1, 1, 1});
    });
    // Written by a pass it is as any other: it has to be stated.
    frame.raster("clear", {.color = {source}}, [](Raster&) {});
    CHECK(failure_of([&] {
              frame.compute("sum", {.writes = {sum}}, [&](Compute& pass) { pass.use(halve).set("source", source); });
          }) == "pass 'sum' binds 'source' without stating it in its reads");
    frame.end();
    CHECK(read<float>(copy) == texels);
    CHECK(value(sum) == 11.0f);
}

namespace {

std::string reader(const std::string& declaration, const std::string& expression) {
    return "layout(local_size_x = 1) in;\nuniform " + declaration +
           " map;\nlayout(scalar) buffer SeenBuffer { float seen[]; };\nvoid main() { " + expression + " }\n";
}

}  // namespace

TEST_CASE_METHOD(OnDevice, "wrapping, borders, filters and levels are as the sampler says") {
    Image map = image({.format = one_float, .size = {2, 1}, .mips = 2});
    const auto level = [](std::initializer_list<float> values) {
        std::vector<std::byte> bytes(4 * values.size());
        std::memcpy(bytes.data(), values.begin(), bytes.size());
        return bytes;
    };
    gpu.upload(map, {level({10, 20}), level({100})});
    const Buffer seen(gpu.device, {.name = "seen", .bytes = 16});
    const Pipeline look = compute_pipeline("wrap", reader("sampler2D", R"(
    seen[0] = textureLod(map, vec2(0.5, 0.5), 0.0).r;
    seen[1] = textureLod(map, vec2(-0.25, 0.5), 0.0).r;
    seen[2] = textureLod(map, vec2(1.1, 0.5), 0.0).r;
    seen[3] = textureLod(map, vec2(0.25, 0.5), 0.5).r;
)"));
    const auto seen_by = [&](const Sampler& sampler) {
        frame.compute("wrap", {.writes = {seen}}, [&](Compute& pass) {
            pass.use(look).set("map", map, sampler).set("seen", seen).dispatch({1, 1, 1});
        });
        frame.end();
        frame.begin({4, 4}, 0);
        return read<float>(seen);
    };
    const auto of = [&](Filter filter, Wrap wrap, Border border = Border::opaque_black) {
        return seen_by({.filter = filter, .wrap = wrap, .border = border});
    };
    CHECK(of(Filter::linear, Wrap::clamp)[0] == Approx(15));
    CHECK(of(Filter::nearest, Wrap::repeat)[1] == 20);
    CHECK(of(Filter::nearest, Wrap::repeat)[2] == 10);
    CHECK(of(Filter::nearest, Wrap::mirror)[1] == 10);
    CHECK(of(Filter::nearest, Wrap::mirror)[2] == 20);
    CHECK(of(Filter::nearest, Wrap::clamp)[1] == 10);
    CHECK(of(Filter::nearest, Wrap::border)[1] == 0);
    CHECK(of(Filter::nearest, Wrap::border, Border::opaque_white)[2] == 1);
    CHECK(of(Filter::nearest, Wrap::clamp)[3] == Approx(55));
    CHECK(seen_by({.mip_filter = Filter::nearest, .wrap = Wrap::clamp, .min_lod = 1})[0] == 100);
    CHECK(seen_by({.wrap = Wrap::clamp, .max_lod = 0})[3] == 10);
    CHECK(seen_by(nearest_repeat)[1] == 20);
    CHECK(seen_by(nearest_clamp)[1] == 10);
}

TEST_CASE_METHOD(OnDevice, "samplers that are equal are one") {
    Samplers samplers(gpu.device);
    const VkSampler first = samplers[linear_repeat];
    CHECK(samplers[Sampler{}] == first);
    CHECK(samplers[linear_clamp] != first);
    CHECK(samplers[Sampler{.anisotropy = 4}] != first);
    CHECK(samplers[Sampler{.wrap = Wrap::clamp}] == samplers[linear_clamp]);
    CHECK(samplers.size() == 3);
}
