// The picture on which a chapter's window opens.
#include "catch.h"
#include "common/app/options.h"

using namespace lightwalk;

namespace {

// A chapter of another one's name, with the knobs that its best shot sets.
struct OpeningTrial : Chapter {
    struct Lens : Module {
        using Module::Module;
        Choice method{*this, "method", {"off", "gather"}, "off", "depth of field"};
    } dof{*this, "dof"};
    struct Effects : Module {
        using Module::Module;
        Choice tone{*this, "tone", {"off", "agx"}, "off", "tone curve"};
        Choice exposure{*this, "exposure", {"automatic", "fixed"}, "automatic", "exposure"};
        Knob<float> stops{*this, "stops", 0, {-10, 10}, "exposure in stops"};
        Knob<bool> vignette{*this, "vignette", false, "darker corners"};
    } post{*this, "post"};

    OpeningTrial(const std::string& of, std::vector<std::string> words = {}) {
        name = of;
        words.insert(words.begin(), of);
        std::vector<char*> arguments;
        for (std::string& word : words) arguments.push_back(word.data());
        options = read_options(int(arguments.size()), arguments.data(), *this).value();
    }
    std::string default_scene() const override { return ""; }
    Model load_model(const std::filesystem::path&) override { return {}; }
    void frame(Frame&) override {}
    Options options;
};

}  // namespace

TEST_CASE("a window opens on the shot that its chapter names as the best", "[common.opening]") {
    const OpeningTrial shadows("05_shadow_maps");
    CHECK(shadows.options.shot == "columns");
    CHECK(shadows.options.scene == "assets/scenes/colonnade_evening.json");
    const OpeningTrial effects("09_post_effects", {"--size", "320x180"});
    CHECK(effects.options.shot == "evening");
    CHECK(effects.options.scene == "assets/scenes/still_life.json");
    CHECK(effects.options.size == glm::uvec2(320, 180));
    CHECK(effects.dof.method.is("gather"));
    CHECK(effects.post.tone.is("agx"));
    CHECK(effects.post.vignette);
}

TEST_CASE("a picture that was asked for is not replaced by the best shot", "[common.opening]") {
    const std::vector<std::vector<std::string>> asked = {
        {"--scene", "assets/scenes/bunny.json"}, {"--screenshot", "a.png"}, {"--set", "post.stops=1"}, {"--time", "1"}};
    for (const auto& words : asked) {
        INFO(words[0]);
        const OpeningTrial trial("09_post_effects", words);
        CHECK(trial.options.shot.empty());
        CHECK(trial.dof.method.is("off"));
    }
    CHECK(OpeningTrial("04_surface_maps").options.shot.empty());  // lava at 2 s: a window's clock begins at 0
}
