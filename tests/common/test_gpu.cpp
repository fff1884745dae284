// The framework: statements of passes, bindings by name, shaders and their cache.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>

#include "catch.h"
#include "common/app/read_picture.h"
#include "common/base/error.h"
#include "common/base/exercise.h"
#include "common/base/files.h"
#include "common/base/kept.h"
#include "common/check/check.h"
#include "common/gpu/frame.h"
#include "common/gpu/gpu_work.h"

using namespace lightwalk;

TEST_CASE("a chapter cannot include a later one, nor a file that is not there, nor within #if") {
    CHECK_THROWS_WITH(flatten_text("#include \"02_lambert_phong/lambert.glsl\"\n", "x", "01", {}),
                      Catch::Matchers::Contains("x:1: chapter 01 may not include the later chapter's"));
    CHECK_THROWS_WITH(flatten_text("\n#include \"common/absent.glsl\"\n", "x", "01", {}),
                      Catch::Matchers::Contains("x:2: no file shaders/common/absent.glsl"));
    CHECK_THROWS_WITH(flatten_text("#if A\n#include \"common/srgb.glsl\"\n#endif\n", "x", "01", {}),
                      Catch::Matchers::Contains("x:2: #include within #if"));
}

TEST_CASE("a test's text replaces a file that is included after it; a shader's may not") {
    const std::string own = "#pragma replaces \"common/srgb.glsl\"\nvec3 encode_srgb(vec3 own) { return own; }\n",
                      include = "#include \"common/srgb.glsl\"\n";
    const FlatShader flat = flatten_text(own + include, "test", "01", {});
    CHECK(flat.files.empty());
    CHECK(flat.text.find("vec3 linear") == flat.text.npos);
    CHECK_THROWS_WITH(flatten_text(include + own, "test", "01", {}),
                      Catch::Matchers::Contains("test:2: shaders/common/srgb.glsl was read before it is replaced"));
    CHECK_THROWS_WITH(flatten_text(own, "shaders/01_obj/exercise/transform.glsl", "01", {}),
                      Catch::Matchers::Contains("only tests replace a shader"));
    CHECK_THROWS_WITH(flatten_text("#pragma replaces \"common/absent.glsl\"\n", "test", "01", {}),
                      Catch::Matchers::Contains("test:1: no file shaders/common/absent.glsl"));
}

TEST_CASE("a replaced file is read in place of the one that is included, of a later chapter too") {
    const std::string text =
        "#include \"common/put_surface.glsl\"\nvoid main() { put_surface(vec3(0.0), 1.0, vec3(1.0)); }\n";
    const FlatShader plain = flatten_text(text, "test", "01", {});
    CHECK(plain.text.find("layout(location = 0) out vec4 color;") != plain.text.npos);
    const Macros macros = Macros().replace_file("common/put_surface.glsl", "common/srgb.glsl");
    const FlatShader other = flatten_text(text, "test", "01", macros);
    CHECK(other.text.find("out vec4 color") == other.text.npos);
    REQUIRE(other.files.size() == 1);
    CHECK(other.files[0].filename() == "srgb.glsl");
}

TEST_CASE("only macros that a shader names make another variant of it") {
    const Macros defines{{"METHOD", "1"}, {"UNUSED", "2"}};
    const std::string text = flatten_text("#if METHOD == 1\n#endif\n", "x", "01", defines).text;
    CHECK(text.find("#define METHOD 1") != text.npos);
    CHECK(text.find("UNUSED") == text.npos);
}

TEST_CASE("a damaged cache entry is rebuilt, and many threads may fill the cache at once") {
    const std::string text =
        flatten_text("layout(local_size_x = 1) in;\nvoid main() {}\n// " + std::to_string(getpid()), "cache.comp", "99",
                     {})
            .text;
    std::vector<std::vector<uint32_t>> results(8);
    {
        std::vector<std::jthread> threads;
        for (auto& result : results)
            threads.emplace_back([&] { result = compile(Stage::compute, text, "cache.comp"); });
    }
    for (const auto& result : results) CHECK(result == results[0]);
    std::filesystem::path newest;
    for (const auto& entry : std::filesystem::directory_iterator(cache_folder()))
        if (newest.empty() || entry.last_write_time() > std::filesystem::last_write_time(newest)) newest = entry.path();
    std::ofstream(newest, std::ios::binary | std::ios::in | std::ios::out).seekp(24).put('x');
    CHECK(compile(Stage::compute, text, "cache.comp") == results[0]);
    CHECK(validate_spirv(results[0]).empty());
}

TEST_CASE("validation has said nothing so far") { CHECK_NOTHROW(check_device().device.check_validation()); }

TEST_CASE("a version that does not compile is replaced by the last one of the same toggles, and by no other's",
          "[common.last_good]") {
    PipelineLibrary library(check_device().device);
    library.keep_last_good = true;
    const Pipeline shader = compute({.shader = "last_good", .source = R"(
layout(local_size_x = 1) in;
layout(scalar) writeonly buffer ResultBuffer { uint result[]; };
void main() {
#if BROKEN
    result[0] = nowhere;
#else
    result[0] = 1u;
#endif
}
)"});
    const auto get = [&](const char* broken) {
        Macros macros;
        macros.set("BROKEN", broken);
        const Macros* const all[] = {&macros};
        return library.get(shader, {}, all);
    };
    Exercises::use("solution");
    CHECK(get("0"));  // the reference's
    Exercises::set("02.lambert", false);
    CHECK(get("1") == nullptr);
    const BuiltPipeline* const own = get("0");
    CHECK(own);
    CHECK(get("1") == own);
    Exercises::use("solution");

    // Texts that nothing has used since the edit before are gone.
    const auto builds = [&](const char* text) {
        const auto before = gpu_work.pipelines;
        CHECK(get(text));
        return gpu_work.pipelines - before;
    };
    CHECK(builds("00") == 1);
    CHECK(builds("0x0") == 1);
    library.rebuild();
    CHECK(builds("0x0") == 0);
    library.rebuild();
    CHECK(builds("0x0") == 0);
    CHECK(builds("00") == 1);
}

// IEEE 754: what is .5 as half, as float and as a byte, at the same place in memory.
TEST_CASE("a pixel's value is read by its image's format", "[common.texel_value]") {
    const glm::vec4 value(0.5f, 49100.0f, -0.25f, 1.0f);
    const uint16_t halves[] = {0x3800, 0x79fe, 0xb400, 0x3c00};
    const uint8_t bytes[] = {255, 0, 51, 255};
    CHECK(texel_value(VK_FORMAT_R32G32B32A32_SFLOAT, std::as_bytes(std::span(&value, 1))) == value);
    CHECK(texel_value(VK_FORMAT_R16G16B16A16_SFLOAT, std::as_bytes(std::span(halves))) ==
          glm::vec4(0.5f, 49088.0f, -0.25f, 1.0f));
    CHECK(glm::length(texel_value(VK_FORMAT_R8G8B8A8_UNORM, std::as_bytes(std::span(bytes))) -
                      glm::vec4(1, 0, 0.2f, 1)) < 1e-6f);
}
