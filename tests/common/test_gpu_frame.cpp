// Over a frame's life: uploads, read-backs, objects destroyed meanwhile, failures half way.
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace {

const Pipeline total = compute_pipeline("total", R"(
layout(local_size_x = 1) in;
layout(scalar) readonly buffer ValuesBuffer { uint values[]; };
layout(scalar) buffer TotalBuffer { uint sum; uint count; } total;
void main() {
    uint sum = 0u;
    for (int i = 0; i < values.length(); ++i) sum += values[i];
    total.sum = sum;
    total.count = uint(values.length());
}
)");

std::vector<uint32_t> counting(size_t n) {
    std::vector<uint32_t> result(n);
    for (size_t i = 0; i < n; ++i) result[i] = static_cast<uint32_t>(i);
    return result;
}

}  // namespace

TEST_CASE_METHOD(OnDevice, "an upload within a frame grows its buffer, is timed, and each pass sees its own") {
    Buffer values;
    const Buffer out(gpu.device, {.name = "out", .bytes = 16});
    ReadBack small, large;
    const auto sum = [&] {
        frame.compute("total", {.writes = {out}}, [&](Compute& pass) {
            pass.use(total).set("values", values).set("total", out).dispatch({1, 1, 1});
        });
    };
    for (const size_t n : {10u, 100u, 50000u, 50u}) {
        frame.begin({4, 4}, 0);
        frame.upload("values", values, counting(4));
        sum();
        frame.read_back(out, small);
        frame.upload("values", values, counting(n));
        sum();
        frame.read_back(out, large);
        frame.end();
        CHECK(small.as<uint32_t>()[0] == 6);
        CHECK(small.as<uint32_t>()[1] == 4);
        CHECK(large.as<uint32_t>()[0] == static_cast<uint32_t>(n * (n - 1) / 2));
        CHECK(large.as<uint32_t>()[1] == n);
        REQUIRE(frame.times.size() == 6);
        CHECK(frame.times[0].name == "values");
        CHECK(frame.times[0].stage == "transfer");
        CHECK(gpu.device.retired_count() == 0);
    }
    CHECK(values.bytes == 200);
    CHECK(values.capacity >= 200000);
}

TEST_CASE_METHOD(OnDevice, "a level of an image is uploaded within a frame") {
    const Image chain = image({.format = one_float, .size = {4, 2}, .mips = 2});
    const std::vector<float> eight{1, 2, 3, 4, 5, 6, 7, 8}, two{9, 10};
    frame.upload("level 0", chain.mip(0), std::as_bytes(std::span(eight)));
    frame.upload("level 1", chain.mip(1), std::as_bytes(std::span(two)));
    CHECK(failure_of([&] { frame.upload("x", chain.mip(1), std::as_bytes(std::span(eight))); }) ==
          "upload of 32 bytes into test mip 1, which holds 8");
    frame.end();
    CHECK(read<float>(chain) == eight);
    CHECK(read<float>(chain.mip(1)) == two);
}

TEST_CASE_METHOD(OnDevice, "a read-back arrives when its frame has ended, and keeps the last one until then") {
    const Image picture = image({.format = one_float, .size = {2, 1}});
    ReadBack seen;
    CHECK_FALSE(seen);
    for (int i = 0; i < 3; ++i) {
        frame.begin({4, 4}, 0);
        frame.raster("fill", {.color = {clear(picture, glm::vec4(float(i)))}}, [](Raster&) {});
        {
            ReadBack dropped;  // goes before the frame ends
            frame.read_back(picture, dropped);
        }
        frame.read_back(picture, seen);
        CHECK(seen.as<float>() == (i == 0 ? std::vector<float>{} : std::vector<float>(2, float(i - 1))));
        frame.end();
        CHECK(seen.as<float>() == std::vector<float>(2, float(i)));
        CHECK(frame.times.back().name == "read back test");
    }
}

TEST_CASE_METHOD(OnDevice, "what recorded passes use lives until the frame has ended") {
    const Buffer out(gpu.device, {.name = "out", .bytes = 16});
    {
        const Buffer values = gpu.upload("short-lived", counting(5));
        frame.compute("total", {.writes = {out}}, [&](Compute& pass) {
            pass.use(total).set("values", values).set("total", out).dispatch({1, 1, 1});
        });
    }
    // The same image with another size: the first one is drawn into already.
    Image bloom = image({.size = {8, 8}});
    frame.raster("a", {.color = {clear(bloom, glm::vec4(1))}}, [](Raster&) {});
    bloom = image({.size = {4, 4}});
    frame.raster("b", {.color = {clear(bloom, glm::vec4(1))}}, [](Raster&) {});
    CHECK(gpu.device.retired_count() == 3);  // an image, a buffer, and their staging buffer
    frame.end();
    CHECK(gpu.device.retired_count() == 0);
    CHECK(read<uint32_t>(out)[0] == 10);

    frame.begin({4, 4}, 0);
    { const Buffer gone(gpu.device, {.name = "gone", .bytes = 16}); }
    CHECK(gpu.device.retired_count() == 1);
    frame.end();
    CHECK(gpu.device.retired_count() == 0);
}

TEST_CASE_METHOD(OnDevice, "a frame within another one is refused: it would run before what the first has recorded") {
    Frame second(gpu);
    CHECK(failure_of([&] { second.begin({4, 4}, 0); }) == "a frame begins while another one is being recorded");
    frame.end();
    second.begin({4, 4}, 0);
    second.end();
}

TEST_CASE_METHOD(OnDevice, "what no pass of this frame wrote is not read, unless it was uploaded or is kept") {
    const Image now = image({.format = one_float, .size = {4, 4}});
    const Image kept = image({.name = "kept", .format = one_float, .size = {4, 4}, .kept = true});
    Image given = image({.name = "given", .format = one_float, .size = {4, 4}});
    gpu.upload(given, std::vector<std::byte>(4 * 16));
    const auto reading = [&](const Image& image) {
        return failure_of([&] { frame.compute("look", {.reads = {image}}, [](Compute&) {}); });
    };
    const auto drawing_on = [&](const Image& image) {
        return failure_of([&] { frame.raster("go on", {.color = {keep(image)}}, [](Raster&) {}); });
    };
    const auto write = [&](const Image& image) {
        frame.raster("write", {.color = {clear(image, glm::vec4(1))}}, [](Raster&) {});
    };
    CHECK(reading(now) == "pass 'look' reads test, which no pass of this frame wrote");
    CHECK(drawing_on(now) == "pass 'go on' reads test, which no pass of this frame wrote");
    CHECK(reading(given) == "");
    write(now);
    write(kept);
    CHECK(reading(now) == "");
    CHECK(drawing_on(now) == "");
    frame.end();
    frame.begin({4, 4}, 0);
    CHECK(reading(now) == "pass 'look' reads test, which no pass of this frame wrote");
    CHECK(reading(kept) == "");
    CHECK(reading(given) == "");
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "a frame of more passes than one submission holds runs them all, in order") {
    const Image counted = image({.format = one_float});
    frame.raster("zero", {.color = {clear(counted, glm::vec4(0))}}, [](Raster&) {});
    const Pipeline add = compute_pipeline("add", R"(
layout(local_size_x = 1) in;
layout(r32f) uniform image2D counted;
void main() { imageStore(counted, ivec2(0), imageLoad(counted, ivec2(0)) + 1.0); })");
    for (int i = 0; i < 3000; ++i)
        frame.compute("add", {.reads = {counted}, .writes = {counted}}, [&](Compute& pass) {
            pass.use(add).set("counted", counted).dispatch({1, 1, 1});
        });
    frame.end();
    CHECK(frame.times.size() == 3001);
    CHECK(value(counted) == 3000.0f);

    // An upload with a pass that begins the next submission, and one after it, which must not take its place.
    frame.begin({4, 4}, 0);
    for (int i = 0; i < 2048; ++i) frame.raster("zero", {.color = {clear(counted, glm::vec4(0))}}, [](Raster&) {});
    Buffer first, second;
    frame.upload("first", first, std::vector<uint32_t>(8, 1));
    frame.upload("second", second, std::vector<uint32_t>(8, 2));
    frame.end();
    CHECK(read<uint32_t>(first)[7] == 1);
    CHECK(read<uint32_t>(second)[7] == 2);
}

TEST_CASE("a constructor that throws half way leaves nothing behind") {
    std::vector<std::string> messages;
    DeviceOptions options = validated();
    options.on_message = [&](const char* text) { messages.push_back(text); };
    {
        Gpu gpu(options);
        CHECK_THROWS_WITH(Buffer(gpu.device, {.name = "huge", .bytes = VkDeviceSize(1) << 62}),
                          Catch::Matchers::Contains("buffer huge of"));
        CHECK_THROWS_WITH(Image(gpu.device, {.name = "huge",
                                             .format = four_floats,
                                             .size = {8192, 8192},
                                             .layers = gpu.device.properties.limits.maxImageArrayLayers}),
                          Catch::Matchers::Contains("image huge"));
        CHECK_THROWS_WITH(Image(gpu.device, {.name = "wide", .size = {1u << 30, 1}}),
                          Catch::Matchers::Contains("image wide: the device has at most"));
    }
    CHECK(messages.empty());
    // Every call that can fail does, one after the other.
    int failures = 0;
    for (int n = 0;; ++n) {
        checks_until_failure() = n;
        try {
            Gpu gpu(options);
            const Buffer buffer(gpu.device, {.name = "buffer", .bytes = 64, .host_visible = true});
            const Image image(gpu.device, {.name = "image", .size = {4, 4}, .mips = 2});
            ImageView(image).mip(1).handle();
            gpu.samplers[nearest_repeat];
            Frame frame(gpu);
            const Buffer uploaded = gpu.upload("uploaded", counting(100));
            frame.begin({4, 4}, 0);
            frame.compute("total", {.writes = {buffer}}, [&](Compute& pass) {
                pass.use(total).set("values", uploaded).set("total", buffer).dispatch({1, 1, 1});
            });
            frame.end();
            checks_until_failure() = -1;
            break;
        } catch (const Failure& e) {
            ++failures;
            CHECK_THAT(e.what(), Catch::Matchers::EndsWith(": forced"));
        }
        INFO("failure " << n << ": " << (messages.empty() ? "" : messages[0]));
        REQUIRE(messages.empty());
    }
    CHECK(failures > 30);
}

TEST_CASE_METHOD(OnDevice, "a write waits for the write before and for all who have read since; a read for the write") {
    const Access vertex_read{VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT,
                             VK_IMAGE_LAYOUT_GENERAL, false};
    const Access fragment_read{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_READ_BIT,
                               VK_IMAGE_LAYOUT_GENERAL, false};
    const Access compute_write{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                               VK_IMAGE_LAYOUT_GENERAL, true};
    const VkPipelineStageFlags2 readers = vertex_read.stages | fragment_read.stages;
    const Buffer buffer(gpu.device, {.name = "buffer", .bytes = 16});
    const Image picture = image({.size = {4, 4}});
    const auto waits_for = [&](const Access& next) {
        Barriers barriers;
        barriers.add(buffer, next);
        barriers.add(picture, next);
        const auto of_buffer = barriers.buffers.empty() ? 0 : barriers.buffers[0].srcStageMask;
        CHECK(of_buffer == (barriers.images.empty() ? 0 : barriers.images[0].srcStageMask));
        return of_buffer;
    };
    waits_for(compute_write);
    CHECK(waits_for(vertex_read) == compute_write.stages);
    CHECK(waits_for(fragment_read) == compute_write.stages);
    CHECK(waits_for(fragment_read) == 0);
    CHECK((waits_for(compute_write) & readers) == readers);
    CHECK(waits_for(compute_write) == compute_write.stages);
}
