// Properties of several entries: common values, and one edit of all of them.
#include "18_playground/properties.h"
#include "18_playground/tree.h"
#include "editor_fixture.h"

using namespace lightwalk;

namespace {

using Kind = Light::Kind;

struct SeveralLights {
    Document document;
    std::vector<EntryId> ids;
    explicit SeveralLights(const std::vector<Kind>& kinds) {
        for (const Kind kind : kinds)
            ids.push_back(add_light(document, {.kind = kind, .intensity = 1.0f + float(ids.size())}));
    }
    const Light& at(size_t i) const { return *document.at(ids[i]).light(); }
    std::string last_step() const { return document.steps().at(document.done() - 1).name; }
    Said set(const char* name, const glm::vec3& value, glm::bvec3 which = glm::bvec3(true), uint64_t gesture = 0) {
        return set_property(document, ids, light_property(name), value, which, gesture);
    }
};

const glm::bvec3 only_y{false, true, false};

}  // namespace

TEST_CASE("the active entry's kind says who is edited, and the active one is the last") {
    Document document;
    const std::vector<EntryId> objects = add_all(document, {"a", "b"});
    const EntryId light = add_light(document, {}), other = add_light(document, {});
    Selection selection;
    CHECK(edited_together(document, selection).empty());
    selection.set({light, objects[0], other, objects[1]});
    CHECK(edited_together(document, selection) == objects);
    selection.set({objects[1], light, root_entry, objects[0], other});
    CHECK(edited_together(document, selection) == std::vector<EntryId>{light, other});
    selection.set({objects[0], root_entry});
    CHECK(edited_together(document, selection) == std::vector<EntryId>{root_entry});
}

TEST_CASE("values that differ are mixed, number by number, and the value is the active entry's") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b", "c"});
    place(document, ids[0], {{1, 2, 3}, {}, glm::vec3(1)});
    place(document, ids[1], {{1, 5, 3}, {}, glm::vec3(1)});
    place(document, ids[2], {{1, 2, 4}, {}, glm::vec3(1)});
    const SharedValue place_of = shared_value(document, ids, object_property("position"));
    CHECK(place_of.value == glm::vec3(1, 2, 4));
    CHECK(place_of.mixed == glm::bvec3(false, true, true));
    CHECK(place_of.ids == ids);
    CHECK(shared_value(document, {ids[1]}, object_property("position")).mixed == glm::bvec3(false));
    CHECK(shared_value(document, ids, object_property("scale")).mixed == glm::bvec3(false));
    // A group has no material, and a light is no object.
    CHECK(shared_value(document, ids, material_property("opacity", {})).ids.empty());
    CHECK(shared_value(document, ids, light_property("range")).ids.empty());
}

TEST_CASE("one edit of all is one step with the number of entries in its name, and undo brings back each one's own") {
    SeveralLights lights(std::vector<Kind>(12, Kind::spot));
    const std::string before = state_of(lights.document);
    const size_t steps = lights.document.done();
    CHECK(lights.set("colour", {0.25f, 0.5f, 1}) == "");
    CHECK(lights.document.done() == steps + 1);
    CHECK(lights.last_step() == "colour of 12 entries");
    for (size_t i = 0; i < 12; ++i) CHECK(lights.at(i).color == glm::vec3(0.25f, 0.5f, 1));
    CHECK(lights.at(3).intensity == 4.0f);  // not edited
    lights.set("colour", {0.25f, 0.5f, 1});
    CHECK(lights.document.done() == steps + 1);  // nothing has changed
    lights.document.undo();
    CHECK(state_of(lights.document) == before);
    CHECK(set_property(lights.document, {lights.ids[0]}, light_property("colour"), glm::vec3(0.5f)) == "");
    CHECK(lights.last_step() == "colour of spot light");
}

TEST_CASE("only the number that was edited is set: the others stay each entry's own") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b"});
    place(document, ids[0], {{1, 2, 3}, {}, glm::vec3(1)});
    place(document, ids[1], {{4, 5, 6}, {}, {1, 2, 1}});
    CHECK(set_property(document, ids, object_property("position"), {9, 9, 9}, only_y) == "");
    CHECK(document.at(ids[0]).object()->position == glm::vec3(1, 9, 3));
    CHECK(document.at(ids[1]).object()->position == glm::vec3(4, 9, 6));
    set_property(document, ids, object_property("scale"), {7, 3, 7}, only_y);
    CHECK(document.at(ids[0]).object()->scale == glm::vec3(1, 3, 1));
    CHECK(document.at(ids[1]).object()->scale == glm::vec3(1, 3, 1));
}

TEST_CASE("each light gets what its type has: cones, sizes, and a direction of length 1") {
    SeveralLights lights({Kind::directional, Kind::point, Kind::spot, Kind::spot});
    lights.set("outer angle", glm::vec3(10));
    CHECK(lights.last_step() == "outer angle of 2 entries");
    CHECK(lights.at(2).outer_rad == Approx(glm::radians(10.0)));
    CHECK(lights.at(2).inner_rad <= lights.at(2).outer_rad);
    CHECK(lights.at(0).outer_rad == Light{}.outer_rad);
    lights.set("inner angle", glm::vec3(40));  // never wider than the whole
    CHECK(lights.at(3).inner_rad == lights.at(3).outer_rad);
    lights.set("range", glm::vec3(3));
    CHECK((lights.at(0).range_m == 10.0f && lights.at(1).range_m == 3.0f && lights.at(2).range_m == 3.0f));
    lights.set("angular size", glm::vec3(0.5f));
    CHECK(lights.at(0).size_rad == Approx(glm::radians(0.5)));
    CHECK(lights.at(1).size_rad == 0.0f);
    lights.set("direction", {1, 0, 0}, {true, false, false});
    for (const size_t i : {0, 2}) CHECK(glm::length(lights.at(i).direction) == Approx(1.0));
    CHECK(lights.at(2).direction.x == Approx(std::sqrt(0.5)));
    CHECK(lights.at(1).direction == Light{}.direction);
    lights.set("shadow", glm::vec3(1));
    CHECK((lights.at(0).shadow && lights.at(3).shadow));
    lights.set("type", glm::vec3(float(Kind::point)));
    CHECK(lights.last_step() == "type of 3 entries");
    for (size_t i = 0; i < 4; ++i) CHECK(lights.at(i).kind == Kind::point);
}

TEST_CASE("a material's number is the override, or else the model's own; an edit overrides it") {
    Document document;
    SceneObject given = named("given", "models/cube.obj");
    given.material.opacity = 0.5f;
    const EntryId a = add_object(document, given), b = add_object(document, named("plain", "models/cube.obj"));
    Material own;
    own.opacity = 0.75f;
    own.diffuse = {0.1f, 0.2f, 0.3f};
    const auto of_model = [&](EntryId) { return &own; };
    const Property opacity = material_property("opacity", of_model), diffuse = material_property("diffuse", of_model);
    CHECK(shared_value(document, {a, b}, opacity).value.x == 0.75f);
    CHECK(shared_value(document, {a, b}, opacity).mixed.x);
    CHECK_FALSE(shared_value(document, {a, b}, diffuse).mixed.x);
    CHECK(shared_value(document, {a, b}, material_property("transmission", of_model)).value == glm::vec3(1));
    CHECK(set_property(document, {a, b}, diffuse, {0.9f, 0.9f, 0.9f}, only_y) == "");
    CHECK(*document.at(b).object()->material.diffuse == glm::vec3(0.1f, 0.9f, 0.3f));
    CHECK_FALSE(document.at(b).object()->material.opacity);
    for (const char* name :
         {"diffuse", "specular", "emissive", "shininess", "roughness", "metalness", "opacity", "transmission"}) {
        const Property one = material_property(name, of_model);
        CHECK(set_property(document, {a, b}, one, glm::vec3(0.625f)) == "");
        CHECK(shared_value(document, {a, b}, one).value.x == 0.625f);
        CHECK_FALSE(shared_value(document, {a, b}, one).mixed.x);
    }
}

TEST_CASE("what is locked stays as it is and is said; what one would refuse, all are spared") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b", "c"});
    set_locked(document, {ids[1]}, true);
    CHECK(set_property(document, ids, object_property("position"), {5, 5, 5}) == "1 of 3 are locked");
    CHECK(document.at(ids[0]).object()->position.x == 5.0f);
    CHECK(document.at(ids[1]).object()->position.x == 0.0f);
    CHECK(set_property(document, {ids[1]}, object_property("position"), {6, 6, 6}) == "it is locked");
    const std::string before = state_of(document);
    const size_t steps = document.done();
    CHECK(set_property(document, ids, object_property("scale"), {1, 0, 1}, only_y).find("scale of 0") != Said::npos);
    CHECK(state_of(document) == before);
    CHECK(document.done() == steps);
    SeveralLights lights({Kind::point, Kind::point});
    const std::string lit = state_of(lights.document);
    CHECK(lights.set("intensity", glm::vec3(-1)).starts_with("key 'intensity'"));
    CHECK(state_of(lights.document) == lit);
}

TEST_CASE("an edit of 1,000 entries and its undo take less than 5 ms each", "[18.edit_time]") {
    Document document;
    std::vector<EntryId> ids;
    document.begin("many");
    for (int i = 0; i < 10000; ++i) {
        SceneObject object = named(fmt::format("cube {}", i), "models/cube.obj");
        object.position.x = float(i);
        const EntryId id = document.add(root_entry, {.what = object});
        if (i % 10 == 0) ids.push_back(id);
    }
    document.commit();
    const std::string before = state_of(document);
    const Property property = material_property("diffuse", {});
    double reading = 1e9, editing = 1e9, undoing = 1e9;
    for (int i = 0; i < 9; ++i) {
        double start = processor_ms();
        CHECK(shared_value(document, ids, property).ids.size() == 1000);
        reading = std::min(reading, processor_ms() - start);
        start = processor_ms();
        CHECK(set_property(document, ids, property, glm::vec3(0.1f * float(i)), glm::bvec3(true), 5) == "");
        editing = std::min(editing, processor_ms() - start);
    }
    CHECK(document.steps().back().name == "diffuse of 1000 entries");
    for (int i = 0; i < 9; ++i) {
        const double start = processor_ms();
        document.undo();
        undoing = std::min(undoing, processor_ms() - start);
        if (i == 0) CHECK(state_of(document) == before);
        document.redo();
    }
    WARN("1,000 entries: read " << reading << " ms, edited " << editing << " ms, undone " << undoing << " ms");
    CHECK(reading < 5.0 * slower);
    CHECK(editing < 5.0 * slower);
    CHECK(undoing < 5.0 * slower);
}

TEST_CASE("numbers: as many digits as have room are shown; what is typed over has all that the float needs") {
    const auto short_number = [](float value, size_t most) {  // as if all characters had one width
        return lightwalk::short_number(value, [&](const std::string& text) { return text.size() <= most; });
    };
    CHECK(short_number(-0.39036f, 6) == "-0.39");
    CHECK(short_number(-0.39036f, 8) == "-0.39036");
    CHECK(short_number(12345.0f, 5) == "12345");
    CHECK(short_number(0.0f, 1) == "0");
    CHECK(lightwalk::short_number(-0.39036f, [](const auto& text) { return 2 * text.size() - 2 <= 8; }) == "-0.39");
    CHECK(short_number(-1.2345e-20f, 6) == "-1e-20");
    CHECK(exact_format(0.1f) == "%.6g");
    Random random(5);
    for (int i = 0; i < 10000; ++i) {
        const float value = float(random.uniform(-1, 1)) * std::pow(10.0f, float(random.uniform(-38, 38)));
        char text[64];
        std::snprintf(text, sizeof text, exact_format(value).c_str(), double(value));
        REQUIRE(std::strtof(text, nullptr) == value);
    }
}

TEST_CASE("a gesture is taken back as a whole and cannot be done again; the step before it stays") {
    Document document;
    const EntryId id = add_all(document, {"a"}).at(0);
    const std::string before = state_of(document);
    const auto drag = [&](float x) {
        set_property(document, {id}, object_property("position"), {x, 0, 0}, glm::bvec3(true), 7);
    };
    drag(1);
    drag(2);
    CHECK(document.done() == 2);
    CHECK_FALSE(document.take_back(8));
    CHECK(document.take_back(7));
    CHECK(state_of(document) == before);
    CHECK(document.done() == 1);
    CHECK_FALSE(document.redo());
    CHECK_FALSE(document.take_back(7));
}
