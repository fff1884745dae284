// Another chapter's scene: parts that the reader lacks are left out, values that a knob refuses are errors.
#include "catch.h"
#include "common/app/foreign_scene.h"
#include "common/base/error.h"
#include "common/scene/mesh.h"

using namespace lightwalk;

namespace {

struct Lamp : Module {
    using Module::Module;
    Knob<float> power{*this, "power", 1.0f, {0, 10}, "Power", "W"};
};

struct Reader : Module {
    Choice method{*this, "method", {"plain", "tiled"}, "plain", "Method"};
    Knob<int> samples{*this, "samples", 1, {1, 16}, "Samples"};
    Lamp lamp{*this, "lamp"};
    bool load_proxy(const std::filesystem::path& file, Model&) const override { return file.extension() == ".tower"; }
};

// The error, or else what the line about it names.
std::string read(Reader& reader, const std::string& knobs, const std::string& from,
                 const std::string& as = "02_reader") {
    const SceneFile scene = parse_scene(R"({"knobs_of": ")" + from + R"(", "knobs": {)" + knobs + "}}", "a.json");
    ForeignScene foreign("a.json", scene, as, "this chapter");
    const KnobList all = reader.all_knobs();
    try {
        foreign.set_knobs(scene, [&](const std::string& name) -> KnobBase& { return find_knob(all, name); });
    } catch (const InputError& e) { return e.what(); }
    return foreign.left_out();
}

}  // namespace

TEST_CASE("knobs that another chapter's scene has and this one lacks are left out, by module", "[common.foreign]") {
    Reader reader;
    CHECK(read(reader, R"("air.on": "on", "air.haze": 3, "lamp.power": 4, "samples": 2)", "01_writer") == "air");
    CHECK(reader.lamp.power == 4.0f);
    CHECK(reader.samples == 2);
    CHECK(read(reader, R"("lamp.power": 5)", "01_writer").empty());
}

TEST_CASE("a knob that a module lacks is left out under the module's name", "[common.foreign]") {
    Reader reader;
    CHECK(read(reader, R"("lamp.colour": 5, "lamp.power": 3)", "01_writer") == "lamp");
    CHECK(reader.lamp.power == 3.0f);
}

TEST_CASE("a value that a module's knob refuses is an error, whoever saved it", "[common.foreign]") {
    Reader reader;
    const std::string why = "a.json: key 'knobs': lamp.power=11: expected a number from 0 to 10 W";
    CHECK(read(reader, R"("lamp.power": 11)", "01_writer") == why);
    CHECK(read(reader, R"("lamp.power": 11)", "02_reader") == why);
}

TEST_CASE("each chapter has a method of its own: another one's name is left out", "[common.foreign]") {
    Reader reader;
    CHECK(read(reader, R"("method": "tiled")", "01_writer").empty());
    CHECK(reader.method.is("tiled"));
    CHECK(read(reader, R"("method": "traced")", "01_writer") == "method");
    CHECK(read(reader, R"("method": "traced")", "02_reader") ==
          "a.json: key 'knobs': method=traced: expected one of plain, tiled");
}

TEST_CASE("an unknown knob is an error in a scene of this chapter, and of no chapter", "[common.foreign]") {
    Reader reader;
    for (const char* from : {"02_reader", ""})
        CHECK(read(reader, R"("air.haze": 3)", from).starts_with("a.json: key 'knobs': unknown knob 'air.haze'"));
}

TEST_CASE("a knob from the command line keeps its value", "[common.foreign]") {
    Reader reader;
    reader.lamp.power.pinned = true;
    CHECK(read(reader, R"("lamp.power": 5)", "01_writer").empty());
    CHECK(reader.lamp.power == 1.0f);
}

TEST_CASE("a file that only another chapter's module stands for is left out", "[common.foreign]") {
    const Reader reader;
    const SceneFile theirs = parse_scene(R"({"knobs_of": "01_writer"})", "a.json");
    ForeignScene foreign("a.json", theirs, "02_reader", "this chapter");
    int loaded = 0;
    const auto model = [&](const char* file) {
        return foreign.model(reader, file, [&] {
            ++loaded;
            return Model();
        });
    };
    CHECK(model("a/b.tower").materials.size() == 1);
    CHECK(foreign.left_out().empty());
    model("a/b.obj");
    CHECK(loaded == 1);
    CHECK(model("a/alps.hgt").materials.size() == 1);
    CHECK(loaded == 1);
    CHECK(foreign.left_out() == "alps.hgt");

    ForeignScene own("a.json", theirs, "01_writer", "this chapter");
    own.model(reader, "a/alps.hgt", [&] {
        ++loaded;
        return Model();
    });
    CHECK(loaded == 2);  // the loader says what is wrong
}
