// Studies: settings of a scene's entry, measurements, intermediate results.
#include "study_fixture.h"

using namespace lightwalk;
using nlohmann::json;

TEST_CASE_METHOD(StudyTest, "study: what a scene sets holds for its points, its truth and while the chapter prepares") {
    const json result = measure();
    CHECK(chapter.prepared == std::vector<std::pair<std::string, float>>{{"a", 0.5f}, {"b", 1.0f}});
    REQUIRE(result["points"].size() == 6);
    const auto point = [&](size_t i) { return result["points"][i]; };
    CHECK(point(1)["scene"] == "a");
    CHECK(point(1)["knobs"] == json{{"looks", 1}});
    CHECK(point(4)["scene"] == "bright");
    CHECK(point(4)["knobs"] == json{{"light", 1}, {"looks", 1}});
    for (const size_t i : {0u, 3u}) CHECK(point(i)["error"]["max"] == 0);  // the truth is this scene's
    for (const size_t i : {1u, 4u}) CHECK(point(i)["error"]["max"] == 0.125);
    for (const size_t i : {2u, 5u}) CHECK(point(i)["error"]["max"] == 0.0625);
    CHECK(result["scenes"]["bright"]["set"] == json{{"light", 1}});
    CHECK(result["scenes"]["bright"]["file"] == folder.scene("b"));
    // One 8-bit step of a brighter scene is a larger one.
    const double dark = result["scenes"]["a"]["one_step"]["max"],
                 bright = result["scenes"]["bright"]["one_step"]["max"];
    CHECK(dark == Approx(0.0062).margin(0.0005));
    CHECK(bright == Approx(0.0089).margin(0.0005));
    CHECK(result["truth"] == json{{"method", "exact"}, {"knobs", json::object()}, {"exact", true}});
    for (const json& measured : result["points"]) {  // in one round the median is the time
        double sum = 0;
        REQUIRE(measured["time_ms"]["per_pass"].size() == 3);
        for (const json& pass : measured["time_ms"]["per_pass"]) sum += pass.get<double>();
        CHECK(measured["time_ms"]["median"].get<double>() == Approx(sum));
    }
}

TEST_CASE_METHOD(StudyTest, "study: a scene of another chapter may name modules that this one lacks",
                 "[common.foreign]") {
    write_file(folder.scene("a"), R"({"knobs_of": "98_other", "knobs": {"air.haze": 3, "light": 0.5}})");
    const json result = measure();
    CHECK(chapter.prepared[0] == std::pair<std::string, float>("a", 0.5f));
    CHECK(result["points"].size() == 6);
    CHECK(result["points"][1]["error"]["max"] == 0.125);
}

TEST_CASE_METHOD(StudyTest, "study: a truth with samples is doubled in each scene") {
    study["truth"] = {{"set", {{"method", "coarse"}, {"looks", 16}}},
                      {"doubled", {{"method", "coarse"}, {"looks", 32}}},
                      {"most_change", 0.004}};
    const json result = measure();
    CHECK(result["scenes"]["a"]["doubling"]["max"] == Approx(1.0 / 256));
    CHECK(result["truth"]["doubling_change"] == Approx(1.0 / 256));
    CHECK_FALSE(result["truth"].contains("exact"));
    study["truth"]["most_change"] = 0.0039;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains("a: doubling the truth's samples changes it by 0.0039"));
}

TEST_CASE_METHOD(StudyTest, "study: a truth of pictures is their mean, and half of them say how far it moves") {
    chapter.a_seed = 0.125f;
    study["truth"] = {{"set", {{"method", "exact"}}}, {"pictures", 4}, {"most_change", 0.125}};
    const json result = measure();
    CHECK(result["points"][0]["error"]["max"] == 0.1875);  // the mean of seeds 0 to 3 against 0
    CHECK(result["scenes"]["a"]["doubling"]["max"] == 0.125);
    CHECK(result["truth"]["doubling_change"] == 0.125);
    CHECK(result["truth"]["pictures"] == 4);
    study["truth"]["most_change"] = 0.124;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains("a: doubling the truth's samples changes it by 0.125"));
}

TEST_CASE_METHOD(StudyTest, "study: errors of the chapter's own, with the point's knobs, which it finds put back") {
    chapter.measures = true;
    study["error_metric"] = "missing";
    study["metrics"] = {{"missing", "missing light"}};
    const json result = measure();
    CHECK(result["metrics"] == study["metrics"]);
    for (size_t i = 0; i < 6; ++i) {
        const double expected = i % 3 == 0 ? 0 : -0.125 / 512;
        CHECK(result["points"][i]["error"]["missing"] == Approx(expected).margin(0.0003));
        CHECK(result["points"][i]["error"]["width"] == 16);
    }
    CHECK(result["points"][4]["error"]["max"] == 0.125);  // measured before
    const KnobList knobs = chapter.all_knobs();
    chapter.looks.value = 7;
    {
        const KeptKnobs kept(knobs);
        chapter.looks.value = 9;
        chapter.method.set("coarse");
    }
    CHECK(chapter.looks == 7);

    chapter.rude = true;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains("measures 'rmse' as 1"));
    chapter.measures = false;
    CHECK_THROWS_WITH(measure(), Catch::Matchers::Contains("error_metric is 'missing', but no point of a has it"));
}

TEST_CASE_METHOD(StudyTest, "study: the encoded picture can be what is judged: its steps show, and white is the most") {
    chapter.codes = true;
    study["scenes"][1]["set"]["light"] = 1.5;
    const json result = measure();
    const double linear = srgb_to_linear(std::round(255.0f * linear_to_srgb(0.625f)) / 255.0f) -
                          srgb_to_linear(std::round(255.0f * linear_to_srgb(0.5f)) / 255.0f);
    CHECK(result["points"][1]["error"]["max"] == Approx(linear).epsilon(1e-4));
    CHECK(result["points"][1]["error"]["max"] != 0.125);
    CHECK(result["points"][4]["error"]["max"] == 0);
}

TEST_CASE_METHOD(StudyTest, "study: every point and the truth start without a history") {
    chapter.gathers = true;
    study["truth"] = {{"set", {{"method", "exact"}}}, {"doubled", {{"method", "exact"}}}, {"most_change", 0}};
    const json result = measure();
    for (const size_t i : {0u, 3u}) CHECK(result["points"][i]["error"]["max"] == 0);
    for (const size_t i : {1u, 4u}) CHECK(result["points"][i]["error"]["max"] == 0.125);
}

TEST_CASE_METHOD(StudyTest, "study: what the need rule chooses for each budget, and points for some scenes alone") {
    study["size"] = {32, 16};
    study["curves"] = {{{"method", "exact"}},
                       {{"method", "coarse"}, {"set", {{"looks", {1, 512}}}}},
                       {{"method", "coarse"}, {"set", {{"looks", 4}}}, {"where", {{"light", 1}}}}};
    study["budgets"] = {0, 1};
    const json result = measure();
    CHECK(result["points"].size() == 7);
    const json choices = result["scenes"]["bright"]["choices"];
    REQUIRE(choices.size() == 2);
    CHECK(choices[0]["budget"] == 0);
    CHECK(choices[0]["choice"]["error"] == 0);
    CHECK(choices[0]["candidates"].size() == 4);
    CHECK(result["scenes"]["a"]["choices"][0]["candidates"].size() == 3);
    for (const json& c : choices[1]["candidates"]) CHECK(c["enough"] == true);
    study["candidates"] = {{{"method", "coarse"}}};
    CHECK(measure()["scenes"]["a"]["choices"][0]["none_would_do"]);
}

TEST_CASE_METHOD(StudyTest, "study: the size given stands for the study's, and the result says both") {
    json result = measure();
    CHECK(result["size"] == json{16, 8});
    CHECK(result["command"] == "./course study 99");
    chapter.measures = options.size_given = true;
    options.size = {24, 12};
    options.device = "some";
    result = measure();
    CHECK(result["size"] == json{24, 12});
    CHECK(result["points"][0]["error"]["width"] == 24);
    CHECK(result["command"] == "./course study 99 --device some --size 24x12");
}

TEST_CASE_METHOD(StudyTest,
                 "study: interrupted, it goes on after the scenes that are done; another study starts anew") {
    const auto scenes = [&] {
        std::string names;
        for (const auto& [scene, light] : chapter.prepared) names += scene;
        chapter.prepared.clear();
        return names;
    };
    chapter.fails_at = "b";
    CHECK_THROWS_WITH(resume(), "interrupted");
    CHECK(scenes() == "a");
    chapter.fails_at = "";
    const json whole = resume();
    CHECK(scenes() == "b");
    CHECK(whole["points"].size() == 6);
    CHECK(whole["points"][0]["scene"] == "a");
    CHECK(whole["points"][3]["scene"] == "bright");
    resume();
    CHECK(scenes().empty());
    study["scenes"][1]["set"]["light"] = 2;
    resume();
    CHECK(scenes() == "ab");
    options.size_given = true;
    resume();
    CHECK(scenes() == "ab");
}

TEST_CASE_METHOD(StudyTest, "study: charts go into the result as they are") {
    study["charts"] =
        json::parse(R"([{"name": "main"}, {"name": "light", "title": "Time", "x": "knob light", "y": "time",
        "scenes": ["bright"], "methods": ["coarse"], "knobs": {"looks": 2}, "x_scale": "log"}])");
    CHECK(measure()["charts"] == study["charts"]);
    CHECK(refusal().empty());
}

TEST_CASE_METHOD(StudyTest, "study: a curve sets a scene's knob only where it says that it means that knob") {
    study["curves"].push_back({{"method", "exact"}, {"set", {{"light", {2, 3}}}}});
    CHECK(refusal().find("'light' is set by the scene") != std::string::npos);
    study["curves"].back()["where"] = {{"light", 1}};
    CHECK(refusal().empty());
    const json points = measure()["points"];
    size_t bright = 0;
    for (const json& point : points)
        if (point["scene"] == "bright" && point["knobs"].value("light", 0) >= 2) {
            ++bright;
            CHECK(point["error"]["max"].get<double>() > 0);  // the truth has the scene's own light
        }
    CHECK(bright == 2);
    CHECK(points.size() == 3 + 3 + 2);
    // Another scene's curve may set the same knob.
    study["curves"].back()["where"] = {{"light", 4}};
    study["curves"].back()["set"] = {{"looks", {4}}};
    study["scenes"][1]["set"]["looks"] = 2;
    study["curves"][1].erase("set");
    CHECK(refusal().empty());
}
