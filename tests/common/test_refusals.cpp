// Mistakes of a pass, its shaders and its knobs: each is refused in one line, which begins with the statement's file and line.
#include <regex>

#include "common/app/drawing.h"
#include "common/app/target.h"
#include "tests/common/gpu_fixture.h"

using namespace lightwalk;

namespace refusals {

Pipeline shader(const char* name, const std::string& declared, const std::string& body) {
    const std::string size = "layout(local_size_x = 4, local_size_y = 4) in;\n";
    return compute_pipeline(
        name, size + declared + "\nvoid main() { ivec2 at = ivec2(gl_GlobalInvocationID.xy); " + body + " }\n");
}

const std::string into = "layout(r32f) writeonly uniform image2D into;\n";
const std::string store = "imageStore(into, at, vec4(1.0));";

const Pipeline writes = shader("writes.comp", into, store);
const Pipeline samples =
    shader("samples.comp", into + "uniform sampler2D from;", "imageStore(into, at, texelFetch(from, at, 0));");
const Pipeline loads = shader("loads.comp", into + "layout(r32f) readonly uniform image2D from;",
                              "imageStore(into, at, imageLoad(from, at));");
const Pipeline in_place =
    shader("in_place.comp", "layout(r32f) uniform image2D into;", "imageStore(into, at, 2.0 * imageLoad(into, at));");
const Pipeline counts =
    shader("counts.comp", into + "uniform usampler2D from;", "imageStore(into, at, vec4(texelFetch(from, at, 0)));");
const Pipeline packed = shader("packed.comp", "layout(r11f_g11f_b10f) writeonly uniform image2D into;", store);
const Pipeline fixed = shader("fixed.comp", "layout(rgba16) writeonly uniform image2D into;", store);
const Pipeline tens = shader("tens.comp", "layout(rgb10_a2) writeonly uniform image2D into;", store);
const Pipeline viewed = shader("viewed.comp", into + "layout(scalar) uniform ViewBlock { vec4 eye; } view;",
                               "imageStore(into, at, view.eye);");
const Pipeline tinted = shader("tinted.comp", into + "layout(scalar) uniform TintBlock { float strength; } tint;",
                               "imageStore(into, at, vec4(tint.strength));");
const Pipeline listed = shader("listed.comp", into + "layout(scalar) readonly buffer Values { float values[]; };",
                               "imageStore(into, at, vec4(values[0]));");
const Pipeline truncated = shader("truncated.comp", into + "layout(scalar) uniform TintBlock { int strength; } tint;",
                                  "imageStore(into, at, vec4(tint.strength));");
const Pipeline compares = shader("compares.comp", into + "uniform sampler2DShadow from;",
                                 "imageStore(into, at, vec4(texture(from, vec3(0.5))));");
const Pipeline scaled = shader("scaled.comp", into + "layout(scalar) uniform ScaleBlock { float scale; };",
                               "imageStore(into, at, vec4(scale));");
const Pipeline counted = shader("counted.comp", into + "layout(scalar) uniform CountBlock { int count; };",
                                "imageStore(into, at, vec4(count));");
const Pipeline points = shader("points.comp", into + "layout(scalar) readonly buffer Points { vec3 points[]; };",
                               "imageStore(into, at, vec4(points[0], 0.0));");
const Pipeline partly =
    shader("partly.comp", into + "layout(r32f) writeonly uniform image2D more;",
           store + "\n#if TINT_METHOD == TINT_METHOD_TWO\nimageStore(more, at, vec4(1.0));\n#endif\n");
const Pipeline compiled_in = shader("in.comp", into + "layout(scalar) uniform TintBlock { int method; } tint;",
                                    "imageStore(into, at, vec4(tint.method));");

struct Root : Module {};

struct Tint : Module {
    using Module::Module;
    Knob<float> strength{*this, "strength", 0.5f, {0, 1}, "how much"};
    Choice method{*this, "method", {"one", "two"}, "one", "which"};
};

// Rows of a table: the line expected and the mistake. The message names this file, and a line of the row.
void refused(const std::string& expected, const std::function<void()>& mistake,
             SourceLocation row = SourceLocation::current()) {
    const std::string said = failure_at(mistake);
    CAPTURE(expected, said);
    std::smatch parts;
    REQUIRE(std::regex_match(said, parts, std::regex("(.*?):([0-9]+): ([^\n]*)")));
    CHECK(parts[1] == "tests/common/test_refusals.cpp");
    const unsigned line = static_cast<unsigned>(std::stoul(parts[2]));
    CHECK(line >= row.line);
    CHECK(line <= row.line + 8);
    CHECK(parts[3] == expected);
}

TEST_CASE_METHOD(OnDevice, "a pass that disagrees with its shaders is refused at its statement", "[refused]") {
    const auto four = [&](const char* name, VkFormat format) {
        Image made = image({.name = name, .format = format, .size = {4, 4}});
        frame.raster("fill", {.color = {clear(made)}}, [](Raster&) {});
        return made;
    };
    frame.raster("fill", {.depth = clear(frame.depth, 0.0f)}, [](Raster&) {});
    const Image one = four("one", one_float), two = four("two", one_float),
                halves = four("halves", VK_FORMAT_R16G16B16A16_SFLOAT);
    Image uploaded = image({.name = "uploaded", .format = one_float});
    gpu.upload(uploaded, std::as_bytes(std::span("abc")));
    const Image unwritten = image({.name = "unwritten", .format = one_float, .size = {4, 4}}), none;
    const Buffer nothing;
    Root root;
    const Tint tint{root, "tint"}, other{root, "other", "tint"};
    const auto in_shader = [&](const std::string& condition) {
        const Pipeline pipeline = shader("x.comp", "#" + condition + "\n#endif\n" + into, store);
        return failure_at([&] {
            frame.compute("x", {.writes = {one}, .with = {tint}},
                          [&](Compute& pass) { pass.use(pipeline).set("into", one).dispatch_threads(frame.size); });
        });
    };
    const std::string says = "x.comp:2: ";
    CHECK(in_shader("if TINT_METHD == TINT_METHOD_ONE") ==
          says + "nobody defines TINT_METHD; did you mean TINT_METHOD?\n    #if TINT_METHD == TINT_METHOD_ONE");
    for (const char* const test : {"ifdef TINT_METHD", "ifndef TINT_METHD", "if defined(TINT_METHD)"})
        CHECK(in_shader(test) == says + "nobody defines TINT_METHD; did you mean TINT_METHOD?\n    #" + test);
    for (const char* const test : {"if METHOD == TINT_METHOD_ONE", "if tint_method == TINT_METHOD_ONE"})
        CHECK(in_shader(test) == fmt::format("{0}nobody defines {1}; did you mean TINT_METHOD?\n    #{2}", says,
                                             std::string_view(test).substr(3, std::string_view(test).find(" =") - 3),
                                             test));
    CHECK(in_shader("if TINT_METHOD_TWO") ==
          says +
              "TINT_METHOD_TWO is an option's number; write TINT_METHOD == TINT_METHOD_TWO\n    #if TINT_METHOD_TWO");
    CHECK(in_shader("ifdef TINT_METHOD_TWO").starts_with(says + "TINT_METHOD_TWO is an option's number"));
    CHECK(in_shader("ifdef TINT_NOTHING_LIKE_IT").empty());

    refused("pass 'x' draws or dispatches before pass.use(pipeline)",
            [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.dispatch_threads(frame.size); }); });
    refused("pass 'x' draws or dispatches before pass.use(pipeline)",
            [&] { frame.raster("x", {.color = {clear(one)}}, [&](Raster& pass) { pass.draw(3); }); });
    refused("pass 'x' sets a binding before pass.use(pipeline)",
            [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.set("into", one).use(writes); }); });
    refused("pass 'x': writes.comp is a pipeline for frame.compute",
            [&] { frame.raster("x", {.color = {clear(one)}}, [&](Raster& pass) { pass.use(writes).draw(3); }); });
    refused("pass 'x': its shaders have no binding 'onto'; they have: into",
            [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(writes).set("onto", one); }); });
    refused("pass 'x' binds 'into' without stating it in its writes",
            [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(writes).set("into", two); }); });
    refused("pass 'x' draws or dispatches without 'into' being set", [&] {
        frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(writes).dispatch_threads(frame.size); });
    });
    refused("pass 'x' draws or dispatches without 'view' being set; set_view(frame) sets it", [&] {
        frame.compute("x", {.writes = {one}},
                      [&](Compute& pass) { pass.use(viewed).set("into", one).dispatch_threads(frame.size); });
    });
    refused("pass 'x' draws or dispatches without 'tint' being set; is its module stated in .with?", [&] {
        frame.compute("x", {.writes = {one}},
                      [&](Compute& pass) { pass.use(tinted).set("into", one).dispatch_threads(frame.size); });
    });
    refused("the shader's tint.strength is an integer and would cut off the knob's fraction; declare it float", [&] {
        frame.compute("x", {.writes = {one}, .with = {tint}}, [&](Compute& pass) { pass.use(truncated); });
    });
    refused("the shader's tint.method is compiled in: use its macro TINT_METHOD", [&] {
        frame.compute("x", {.writes = {one}, .with = {tint}}, [&](Compute& pass) { pass.use(compiled_in); });
    });
    refused("pass 'x' is given two modules of the kind 'tint'; it takes one", [&] {
        frame.compute("x", {.writes = {one}, .with = {tint, other}}, [&](Compute&) {});
    });
    for (const auto& [pipeline, format] :
         {std::pair(&packed, "B10G11R11UfloatPack32"), std::pair(&fixed, "R16G16B16A16Unorm"),
          std::pair(&tens, "A2B10G10R10UnormPack32")})
        refused(fmt::format("pass 'x': 'into' is {} in the shader, and halves is R16G16B16A16Sfloat", format), [&] {
            frame.compute("x", {.writes = {halves}}, [&](Compute& pass) { pass.use(*pipeline).set("into", halves); });
        });
    refused("pass 'x': 'from' is an image of unsigned integers in the shader, and two is R32Sfloat", [&] {
        frame.compute("x", {.reads = {two}, .writes = {one}},
                      [&](Compute& pass) { pass.use(counts).set("from", two); });
    });
    refused(
        "pass 'x' samples one as 'from' and writes it as 'into' at once; write another image, or read it in place by "
        "imageLoad()",
        [&] {
            frame.compute("x", {.reads = {one}, .writes = {one}}, [&](Compute& pass) {
                pass.use(samples).set("from", one).set("into", one).dispatch_threads(frame.size);
            });
        });
    refused(
        "pass 'x': 'from' is a readonly image in the shader; raster passes and uploaded images are only sampled: "
        "declare "
        "a sampler and use texelFetch(), or state uploaded in writes, too",
        [&] {
            frame.compute("x", {.reads = {uploaded}, .writes = {one}},
                          [&](Compute& pass) { pass.use(loads).set("from", uploaded); });
        });
    refused(
        "pass 'x': 'into' is not writeonly in the shader, and one is stated in writes alone; declare it writeonly, or "
        "state it in reads, too",
        [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(in_place).set("into", one); }); });
    refused("pass 'x' reads unwritten, which no pass of this frame wrote",
            [&] { frame.compute("x", {.reads = {unwritten}}, [](Compute&) {}); });
    refused("pass 'x' states unwritten in its writes, and draws and dispatches nothing", [&] {
        frame.compute("x", {.writes = {unwritten}}, [&](Compute& pass) { pass.use(writes).set("into", unwritten); });
    });
    refused("pass 'x': 'from' compares in the shader, and its sampler does not; set Sampler::compare", [&] {
        frame.compute("x", {.reads = {frame.depth}, .writes = {one}},
                      [&](Compute& pass) { pass.use(compares).set("from", frame.depth); });
    });
    constexpr Sampler comparing{.compare = Compare::greater};
    refused("pass 'x': 'from' is read in the shader, and its sampler compares; declare a sampler2DShadow", [&] {
        frame.compute("x", {.reads = {frame.depth}, .writes = {one}},
                      [&](Compute& pass) { pass.use(samples).set("from", frame.depth, comparing); });
    });
    refused("pass 'x': 'from' compares depths in the shader, and two is no depth image", [&] {
        frame.compute("x", {.reads = {two}, .writes = {one}},
                      [&](Compute& pass) { pass.use(compares).set("from", two, comparing); });
    });
    const std::string filter = ", which has no filter; set it with nearest_clamp";
    refused("pass 'x': 'from' would be filtered, and depth is D32Sfloat" + filter, [&] {
        frame.compute("x", {.reads = {frame.depth}, .writes = {one}},
                      [&](Compute& pass) { pass.use(samples).set("from", frame.depth); });
    });
    const Image whole = four("whole", VK_FORMAT_R32_UINT);
    refused("pass 'x': 'from' would be filtered, and whole is R32Uint" + filter, [&] {
        frame.compute("x", {.reads = {whole}, .writes = {one}},
                      [&](Compute& pass) { pass.use(counts).set("from", whole); });
    });
    const auto of = [](const char* binding, const char* in_cpp, const char* in_glsl) {
        return fmt::format("pass 'x': '{}' is {} in C++ and {} in the shader, which would take its bits", binding,
                           in_cpp, in_glsl);
    };
    refused(of("scale", "an integer", "a float"),
            [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(scaled).set("scale", 1); }); });
    refused(of("count", "a float", "an integer"), [&] {
        frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(counted).set("count", 1.0f); });
    });
    refused("pass 'x': 'scale' is 16 bytes in C++ and 4 in the shader", [&] {
        frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(scaled).set("scale", glm::vec4(1)); });
    });
    refused("pass 'x': 'view' is 4 bytes in C++ and 16 in the shader",
            [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(viewed).set("view", 1.0f); }); });
    const Buffer wide = gpu.upload("wide", std::vector<glm::vec4>(2)), own(gpu.device, {.name = "own", .bytes = 16});
    refused("pass 'x' binds 'values' without stating it in its reads", [&] {
        frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(listed).set("values", own); });
    });
    refused("pass 'x': an element of 'points' has 12 bytes in the shader, and one of wide has 16 in C++", [&] {
        frame.compute("x", {.reads = {wide}, .writes = {one}},
                      [&](Compute& pass) { pass.use(points).set("points", wide); });
    });
    refused("pass 'x' sets 'scale' after its last draw or dispatch, so that nothing reads it", [&] {
        frame.compute("x", {.writes = {one}}, [&](Compute& pass) {
            pass.use(scaled).set("into", one).set("scale", 1.0f).dispatch_threads(frame.size).set("scale", 2.0f);
        });
    });
    refused("pass 'x' sets 'scale' after its last draw or dispatch, so that nothing reads it", [&] {
        frame.compute("x", {.writes = {one}}, [&](Compute& pass) {
            pass.use(scaled).set("into", one).set("scale", 1.0f).dispatch_threads(frame.size).set("scale", 2.0f);
            pass.wait().use(writes).set("into", one).dispatch_threads(frame.size);
        });
    });
    refused("pass 'x' dispatches 0×1×1 workgroups", [&] {
        frame.compute("x", {.writes = {one}},
                      [&](Compute& pass) { pass.use(writes).set("into", one).dispatch_threads(glm::uvec2(0, 4)); });
    });
    refused("pass 'x' draws 0 vertices", [&] {
        frame.raster("x", {.color = {clear(one)}}, [&](Raster& pass) { pass.use(quad_pipeline()).draw(0); });
    });
    refused("pass 'x': target one is stated twice", [&] {
        frame.raster("x", {.color = {clear(one), clear(one)}}, [](Raster&) {});
    });
    refused("a pass has no name, by which timers and messages call it",
            [&] { frame.compute("", {}, [](Compute&) {}); });
    const std::string size = " without a size: a Target has one in Chapter::frame, an Image after ensure()";
    refused("pass 'x' states an image" + size, [&] { frame.compute("x", {.writes = {none}}, [](Compute&) {}); });
    refused("pass 'x': 'into' gets an image" + size,
            [&] { frame.compute("x", {.writes = {one}}, [&](Compute& pass) { pass.use(writes).set("into", none); }); });
    refused("pass 'x': a target has no size: a Target has one in Chapter::frame, an Image after ensure()",
            [&] { frame.raster("x", {.color = {clear(none)}}, [](Raster&) {}); });
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "where each thread writes its own texel, workgroups cover the image", "[refused]") {
    const auto sized = [&](const char* name, glm::uvec2 size) {
        return image({.name = name, .format = one_float, .size = size, .mips = 2, .kept = true});
    };
    const Image ten = sized("ten", {10, 8}), four = sized("four", {4, 4});
    const Buffer list(gpu.device, {.name = "list", .bytes = 4096});
    const auto dispatch = [&](const Pipeline& pipeline, glm::uvec2 groups, const ImageView& view) {
        frame.compute("x", {.reads = {list}, .writes = {view, list}}, [&](Compute& pass) {
            pass.use(pipeline).set("into", view);
            if (pass.wants("list")) pass.set("list", list);
            pass.dispatch({groups, 1});
        });
    };
    const auto said = [](glm::uvec2 groups) {
        return fmt::format(
            "pass 'x' dispatches {}×{} workgroups of 4×4 threads; 'into' has 10×8 texels and needs 3×2: "
            "dispatch_threads(size) counts texels",
            groups.x, groups.y);
    };
    for (const glm::uvec2 wrong :
         {glm::uvec2(2, 2), glm::uvec2(1, 1), glm::uvec2(3, 1), glm::uvec2(10, 8), glm::uvec2(3, 3), glm::uvec2(4, 1)})
        refused(said(wrong), [&] {
            frame.compute("x", {.writes = {ten}}, [&](Compute& pass) {
                pass.use(writes).set("into", ten).dispatch({wrong, 1});
            });
        });
    CHECK_NOTHROW(dispatch(writes, {3, 2}, ten));
    CHECK_NOTHROW(dispatch(writes, {2, 1}, ten.mip(1)));

    // Every way to the thread's own texel is found; other ones are the pass's own business.
    const auto row = [&](const char* body) { return shader("x.comp", into, body); };
    const Pipeline own[] = {
        row("uvec2 texel = gl_GlobalInvocationID.xy; if (at.x < 9) imageStore(into, ivec2(texel), vec4(1.0));"),
        row("imageStore(into, ivec2(gl_GlobalInvocationID.xy), vec4(at.x + at.y)); imageStore(into, at, vec4(2.0));")};
    for (const Pipeline& pipeline : own)
        CHECK(failure_at([&] { dispatch(pipeline, {2, 2}, ten); }).ends_with(said({2, 2})));
    const Pipeline another[] = {
        row("imageStore(into, at + 4, vec4(1.0));"),
        row("imageStore(into, at, vec4(1.0)); imageStore(into, at.yx, vec4(1.0));"),
        row("at.x *= 4; imageStore(into, at, vec4(1.0));"),
        row("if (at.y > 2) at = ivec2(1); imageStore(into, at, vec4(1.0));"),
        row("imageStore(into, ivec2(gl_WorkGroupID.xy), vec4(1.0));"),
        row("imageStore(into, ivec2(gl_LocalInvocationID.xy), vec4(1.0));"),
        shader("x.comp", into + "void move(inout ivec2 at) { at += 4; }", "move(at); imageStore(into, at, vec4(1.0));"),
        shader("x.comp", into + "void put(ivec2 at) { imageStore(into, at, vec4(1.0)); }", "put(at + 1); put(at);"),
        shader("x.comp", "layout(r32f) writeonly uniform image2D into[1];", "imageStore(into[0], at, vec4(1.0));")};
    for (const Pipeline& pipeline : another)
        for (const glm::uvec2 groups : {glm::uvec2(1, 1), glm::uvec2(10, 8)})
            CHECK_NOTHROW(dispatch(pipeline, groups, ten));
    const Pipeline lists =
        shader("x.comp", into + "layout(scalar) buffer List { float list[]; };",
               "list[gl_GlobalInvocationID.x] = 1.0; if (at.x < imageSize(into).x) imageStore(into, at, vec4(1.0));");
    CHECK_NOTHROW(dispatch(lists, {9, 9}, four));  // threads beyond the image fill the list
    CHECK(failure_at([&] { dispatch(lists, {9, 1}, ten); }).ends_with(said({9, 1})));
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "a shader's outputs and a pass's targets are the same", "[refused]") {
    const auto four = [&](const char* name, VkFormat format) {
        return image({.name = name, .format = format, .size = {4, 4}});
    };
    const Image first = four("first", four_floats), second = four("second", four_floats),
                whole = four("whole", VK_FORMAT_R32_UINT);
    const Pipeline paints = quad_pipeline(), both = quad_pipeline({}, "paint.frag"),
                   masked = quad_pipeline({.color_write = {write_rgba, write_nothing}});
    const auto draw = [&](const Pipeline& pipeline, std::vector<Attachment> targets) {
        frame.raster("x", {.color = std::move(targets)},
                     [&](Raster& pass) { pass.use(pipeline).set("quad", Quad{}).set("paint", Paint{}).draw(6); });
    };
    const std::string of = "pass 'x': ../tests/common/shaders/paint";
    CHECK(failure_of([&] {
              draw(paints, {clear(first), clear(second)});
          }) == of + "_one.frag: nothing is written to color target 1; declare layout(location = 1) out");
    CHECK(failure_of([&] { draw(paints, {clear(whole)}); }) ==
          of + "_one.frag: 'out first' has floats, and its target is R32Uint");
    const auto built = [&](const std::string& fragment) {
        const Pipeline pipeline = graphics({.vertex = test_shader("quad.vert"), .fragment = fragment});
        return failure_at([&] { draw(pipeline, {clear(first)}); });
    };
    CHECK(built("05_shadow_maps/visible.frag") ==
          "shaders/05_shadow_maps/visible.frag: 'in item' is at location 7, to which " + test_shader("quad.vert") +
              " writes nothing");
    CHECK(built("18_playground/line.frag") ==
          "shaders/18_playground/line.frag: 'in color' differs in type from 'out instance' of " +
              test_shader("quad.vert"));
    CHECK_NOTHROW(draw(both, {clear(first), clear(second)}));
    CHECK_NOTHROW(draw(masked, {clear(first), clear(second)}));
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "what a variant of a shader does not write, its pass may state", "[refused]") {
    const auto four = [&](const char* name) {
        return image({.name = name, .format = one_float, .size = {4, 4}, .kept = true});
    };
    const Image one = four("one"), more = four("more");
    Root root;
    const Tint tint{root, "tint"};  // its method is `one`, which leaves `more` as it is
    frame.compute("x", {.writes = {one, more}, .with = {tint}}, [&](Compute& pass) {
        pass.use(partly).set("into", one).set("more", more).dispatch_threads(frame.size);
    });
    frame.end();
    CHECK(value(one) == 1);
}

TEST_CASE_METHOD(OnDevice, "a readonly image is stated in reads, and may be sampled as well", "[refused]") {
    const Image from = image({.name = "from", .format = one_float, .size = {4, 4}}),
                copy = image({.name = "into", .format = one_float, .size = {4, 4}});
    frame.raster("fill", {.color = {clear(from, glm::vec4(3))}}, [](Raster&) {});
    frame.compute("load", {.reads = {from}, .writes = {copy}}, [&](Compute& pass) {
        pass.use(samples).set("from", from).set("into", copy).dispatch({1, 1, 1});
        pass.wait().use(loads).set("from", from).set("into", copy).dispatch({1, 1, 1});
        pass.wait().use(samples).set("from", from).set("into", copy).dispatch({1, 1, 1});
    });
    frame.compute("sample", {.reads = {from}, .writes = {copy}}, [&](Compute& pass) {
        pass.use(samples).set("from", from).set("into", copy).dispatch({1, 1, 1});
    });
    frame.end();
    CHECK(value(copy) == 3);
}

TEST_CASE_METHOD(OnDevice, "what a shader declares in vain is refused at its line", "[refused]") {
    const Image one = image({.name = "one", .format = one_float, .size = {4, 4}});
    const auto said = [&](const Pipeline& pipeline) {
        return failure_at([&] {
            frame.compute("x", {.writes = {one}},
                          [&](Compute& pass) { pass.use(pipeline).set("into", one).dispatch_threads(frame.size); });
        });
    };
    const auto declared = [&](const std::string& text) { return said(shader("x.comp", text + "\n" + into, store)); };
    const std::string numbered = "' has no effect: bindings are set by name; leave it out";
    CHECK(declared("layout(set = 1) uniform sampler2D from;") == "x.comp:2: 'set" + numbered);
    CHECK(declared("// layout(set = 1)\nlayout(scalar,\n  binding=3) uniform A { float a; };") ==
          "x.comp:3: 'binding" + numbered);
    CHECK(declared("/* layout(set = 1) */ const int offset = 1, reset = 2;").empty());
    CHECK(
        declared("layout(push_constant) uniform Pushed { float a; } pushed;") ==
        "x.comp: 'pushed' is a push-constant block, which no pass sets; declare layout(scalar) uniform, and set it by "
        "name");
    CHECK(declared("uniform texture2D from;") == "x.comp: 'from' is a texture without a sampler; declare a sampler2D");
    const std::string remedy = "; declare the block with layout(scalar)";
    CHECK(declared("uniform Light { vec3 a; vec3 b; } light;") ==
          "x.comp: block 'light': offset of 'b' is 16, in C++ 12" + remedy);
    CHECK(declared("buffer Points { vec3 points[]; };") ==
          "x.comp: block 'points': array stride of 'points' is 16, in C++ 12" + remedy);
    CHECK(declared("buffer Turns { mat3 turn; };") ==
          "x.comp: block 'turn': matrix stride of 'turn' is 16, in C++ 12" + remedy);
    CHECK(declared("struct Two { vec3 a; float b; vec2 c; };\nbuffer Pairs { Two pairs[]; };") ==
          "x.comp: block 'pairs': array stride of 'pairs' is 32, in C++ 24" + remedy);
    CHECK(declared("struct Two { vec3 a; float b; vec2 c; };\nlayout(scalar) buffer Pairs { Two pairs[]; };").empty());
    CHECK(declared("uniform Same { vec4 a; float b; uint c; } same;").empty());  // equal by both rules
    CHECK(said(compute_pipeline("x.comp", into + "void main() { imageStore(into, ivec2(0), vec4(1.0)); }")) ==
          "x.comp:2: no local size; layout(local_size_x = 8, local_size_y = 8) in; suits images");
    const std::string most = std::to_string(gpu.device.properties.limits.maxComputeWorkGroupInvocations);
    CHECK(said(compute_pipeline("x.comp", "layout(local_size_x = 64, local_size_y = 64) in;\nvoid main() {}")) ==
          "shaders/x.comp: a local size of 64×64×1 is 4096 threads; this device has at most " + most);
    CHECK(said(compute_pipeline("x.comp", "layout(local_size_x = 4) in;\nvoid mein() {}")) ==
          "x.comp:2: no void main()");
    CHECK(said(shader("x.comp", into, "vec4 light = nothing.x + nothing.yzw; imageStore(into, at, light);")) ==
          "x.comp:4: 'nothing' : undeclared identifier");
    const std::string stored = "' is never stored to; declare it readonly, or leave it out";
    CHECK(declared("layout(r32f) uniform image2D idle;") == "x.comp:2: image 'idle" + stored);
    CHECK(said(shader("x.comp", into + "layout(r32f) uniform image2D from;",
                      "imageStore(into, at, imageLoad(from, at) * float(imageSize(from).x));")) ==
          "x.comp:3: image 'from" + stored);
    CHECK(declared("layout(r32f) uniform image2D array[2];\nvoid f() { imageStore(array[0], ivec2(0), vec4(1)); }")
              .empty());
    for (const char* const pixel : {"vec2(at)", "vec2(gl_GlobalInvocationID.xy)", "vec2(at) + 0.5"})
        CHECK(said(shader("x.comp", into + "uniform sampler2D from;",
                          fmt::format("imageStore(into, at, texture(from, {}));", pixel))) ==
              "x.comp: 'from' is sampled at a pixel, and texture() takes 0 to 1; use texelFetch()");
    for (const char* const within : {"vec2(at) / 4.0", "(vec2(at) + 0.5) * 0.25", "vec2(0.5)"})
        CHECK(said(shader("x.comp", into + "uniform sampler2D from;",
                          fmt::format("imageStore(into, at, texture(from, {}));", within)))
                  .ends_with("without 'from' being set"));
    const std::string shared = std::to_string(gpu.device.properties.limits.maxComputeSharedMemorySize);
    CHECK(said(shader("x.comp", into + "shared vec4 tile[20][1024];",
                      "tile[0][at.x] = vec4(at.x); barrier(); imageStore(into, at, tile[0][at.y]);")) ==
          "shaders/x.comp: its shared variables take 327680 bytes; this device has at most " + shared);
    CHECK(declared("#include <common/hash.glsl>") == "x.comp:2: a shader is included as \"common/hash.glsl\"");
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "a drawing is drawn once into a canvas", "[refused]") {
    struct Hill : Drawing {
        using Drawing::Drawing;
        void draw(Frame&, const View&, Canvas&) override {}
    };
    Root root;
    Hill hill{root, "hill"}, other{root, "other"};
    Canvas canvas(frame.hdr, frame.depth);
    const View view;
    refused("the drawing 'hill' is given twice", [&] { draw(frame, view, canvas, {hill, other, hill}); });
    draw(frame, view, canvas, {hill, other});
    refused("'other' is drawn twice into one canvas", [&] { draw(frame, view, canvas, {other}); });
    frame.end();
}

TEST_CASE_METHOD(OnDevice, "a shader that is missing is refused at the pipeline's statement", "[refused]") {
    refused("no file shaders/common/encode_srg.comp; the nearest in common: encode_srgb.comp and deform.comp", [&] {
        const Pipeline missing = compute({.shader = "common/encode_srg.comp"});
        frame.compute("x", {}, [&](Compute& pass) { pass.use(missing); });
    });
    refused("no file shaders/shaders/common/encode_srgb.comp; leave out shaders/", [&] {
        const Pipeline twice = compute({.shader = "shaders/common/encode_srgb.comp"});
        frame.compute("x", {}, [&](Compute& pass) { pass.use(twice); });
    });
    refused("the pipeline names no shader, a path below shaders/", [&] {
        const Pipeline nameless = compute({});
        frame.compute("x", {}, [&](Compute& pass) { pass.use(nameless); });
    });
    refused("no file shaders/20_none/x.frag", [&] {
        const Pipeline missing = graphics({.vertex = test_shader("quad.vert"), .fragment = "20_none/x.frag"});
        frame.raster("x", {.color = {clear(frame.hdr)}}, [&](Raster& pass) { pass.use(missing); });
    });
    refused("image flat: its size is 0", [&] {
        check_at(SourceLocation::current(), [&] { image({.name = "flat", .size = {4, 0}}); });
    });
    frame.end();
}

TEST_CASE("a knob's default is one of its values", "[refused]") {
    Root root;
    refused("default of strength=5: expected a number from 0 to 1 m", [&] {
        const Knob<float> strength{root, "strength", 5.0f, {0, 1}, "how much", "m"};
    });
    const Knob<float> taken{root, "taken", 0.5f, {0, 1}, "how much"};
    refused("knob 'taken' stands twice in one module; give one another name", [&] {
        const Knob<float> twice{root, "taken", 0.5f, {0, 1}, "how much"};
    });
    const std::string word = "a name is a letter, then letters, digits and _: it becomes a macro";
    refused("knob 'how much': " + word, [&] { const Knob<float> spaced{root, "how much", 0.5f, {0, 1}, "how much"}; });
    refused("option 'two-way' of method: " + word, [&] {
        const Choice method{root, "method", {"one", "two-way"}, "one", "which"};
    });
    refused("option 'one' of method stands twice", [&] {
        const Choice method{root, "method", {"one", "one"}, "one", "which"};
    });
    refused("knob 'silent' has no help; say in a noun phrase what it sets", [&] {
        const Knob<float> silent{root, "silent", 0.5f, {0, 1}, ""};
    });
    refused("knob 'flag' has no help; say in a noun phrase what it sets", [&] {
        const Knob<bool> flag{root, "flag", true, ""};
    });
    refused("the range of color differs by component, and one holds for all", [&] {
        const Knob<glm::vec3> color{root, "color", glm::vec3(0), {glm::vec3(0), glm::vec3(1, 1, 2)}, "Colour"};
    });
    refused("default of count=0: expected an integer from 1 to 8", [&] {
        const Knob<int> count{root, "count", 0, {1, 8}, "how many"};
    });
    refused("default of method=three: expected one of one, two", [&] {
        const Choice method{root, "method", {"one", "two"}, "three", "which"};
    });
    const Knob<float> tenth{root, "tenth", 0.1f, {0.1f, 0.7f}, "ends of a range are floats"};
    CHECK(tenth == 0.1f);
}

TEST_CASE("a module has a name of its own", "[refused]") {
    Root root;
    const Tint tint{root, "tint", "tint"};
    refused("module 'tint': another module has this name; give one another", [&] {
        const Tint twice{root, "tint", "tint"};
    });
    refused("module 'my tint': a name is a letter, then letters, digits and _: it becomes a macro", [&] {
        const Tint spaced{root, "my tint"};
    });
    refused("module 'knobs': the block 'knobs' is not a module's; take another name", [&] {
        const Tint knobs{root, "knobs"};
    });
    struct Eye : Module {
        explicit Eye(Module& owner) : Module(owner, "eye", "view") {}
    };
    CHECK(failure_at([&] {
              const Eye eye{root};
          }).ends_with("module 'eye': the block 'view' is not a module's; take another name"));
    for (const float scale : {0.0f, -0.5f, NAN})
        refused(fmt::format("target 'flat': a scale of {}; expected one above 0", scale), [&] {
            const Target flat{root, {.name = "flat", .scale = scale}};
        });
    Tint owner{root, "owner", "tint"};
    const Target map{owner, {.name = "map"}};
    const History past{owner, {.name = "past"}}, before{owner, {.name = "before"}};
    refused("target 'owner.map' stands twice in one module; give one another name", [&] {
        const Target twice{owner, {.name = "map"}};
    });
    refused("target 'owner.past' stands twice in one module; give one another name", [&] {
        const History twice{owner, {.name = "past"}};
    });
    const Tint other{root, "other", "tint"};
    CHECK_NOTHROW(check_macros(root.all_knobs()));  // modules of one kind share their macros
    const Knob<bool> clashing{root, "tint_method", true, "Whether it is tinted"};
    CHECK(failure_at([&] { check_macros(root.all_knobs()); }) ==
          "tint.method and tint_method both define the macro TINT_METHOD; give one another name");
}

}  // namespace refusals
