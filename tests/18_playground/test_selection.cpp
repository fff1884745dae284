// A person's selecting, grouping, naming, searching and saving: order, steps, rows of the tree, files.
#include "18_playground/tree.h"
#include "editor_fixture.h"

using namespace lightwalk;

namespace {

std::vector<std::string> names_of(const Document& document, const std::vector<EntryId>& ids) {
    std::vector<std::string> names;
    for (const EntryId id : ids) names.push_back(document.at(id).name());
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("a selection has each entry once, in the order of clicks; what is gone leaves it") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b", "c"});
    Selection selection;
    selection.set({ids[2], ids[0], ids[2]});
    CHECK(selection.ids == std::vector<EntryId>{ids[2], ids[0]});
    selection.toggle(ids[1]);
    CHECK(selection.active() == ids[1]);
    selection.toggle(ids[0]);
    CHECK(selection.ids == std::vector<EntryId>{ids[2], ids[1]});
    CHECK_FALSE(selection.has(ids[0]));
    remove(document, {ids[1]});
    selection.drop_missing(document);
    CHECK(selection.ids == std::vector<EntryId>{ids[2]});
}

TEST_CASE("whatever was clicked first, siblings keep their order: grouped, moved to a place, duplicated, deleted") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b", "c", "d", "e"});
    const auto top = [&] { return names_of(document, document.at(root_entry).children); };
    const EntryId folder = group(document, {ids[3], ids[1]}, "folder");
    CHECK(names_of(document, document.at(folder).children) == Names{"b", "d"});
    CHECK(reparent(document, {ids[3], ids[1]}, root_entry, 1) == "");
    CHECK(top() == Names{"a", "b", "d", "c", "e", "folder"});
    reparent(document, {ids[1]}, folder);
    duplicate(document, {ids[1], folder, ids[0]});
    CHECK(top() == Names{"a", "a 2", "d", "c", "e", "folder", "folder 2"});
    CHECK(document.size() == 9);
    CHECK(names_of(document, document.at(document.at(root_entry).children[6]).children) == Names{"b 2"});
    remove(document, {ids[1], folder});
    CHECK(top() == Names{"a", "a 2", "d", "c", "e", "folder 2"});
    // Within one parent a place is another line and nothing else, to the bit; without a name there is no parent in the file.
    place(document, ids[0], {{0.1f, 0.2f, 0.3f}, {721, 100, -500}, {1, 2, 3}});
    const Placement before = placement_of(*document.at(ids[0]).object());
    reparent(document, {ids[0]}, root_entry, 3);
    CHECK(placement_of(*document.at(ids[0]).object()) == before);
    const EntryId unnamed = add_object(document, named(""));
    reparent(document, {ids[0]}, unnamed);
    CHECK_FALSE(document.at(unnamed).name().empty());
    CHECK(rename(document, unnamed, "") == "what has children has a name");
}

namespace {

float furthest(const glm::mat4& a, const glm::mat4& b) {
    float most = 0;
    for (int i = 0; i < 4; ++i) most = std::max(most, glm::length(a[i] - b[i]));
    return most;
}

}  // namespace

TEST_CASE("a group stands in the middle of what is grouped, below the parent of all; what is in it stays where it was",
          "[18.group]") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"turned", "a", "b", "c", "far"});
    place(document, ids[0], {{5, -2, 3}, {20, 130, -40}, {2, 2, 2}});
    place(document, ids[1], {{1, 0, 0}, {10, 20, 30}, {1, 2, 3}});
    place(document, ids[2], {{3, 4, 0}, {721, 0, 0}, {-1, 1, 1}});
    place(document, ids[3], {{0.1f, 0.7f, -9}, {0, 45, 0}, {0.3f, 0.3f, 0.3f}});
    place(document, ids[4], {{-30, 8, 2}, {}, glm::vec3(1)});
    const auto middle = [&](EntryId id) { return glm::vec3(world_of(document, id)[3]); };
    const auto grouped = [&](const std::vector<EntryId>& some, const Bounds& around = {}) {
        const std::string before = state_of(document);
        std::vector<glm::mat4> worlds;
        for (const EntryId id : ids) worlds.push_back(world_of(document, id));
        const EntryId made = group(document, some, "group", around);
        for (size_t i = 0; i < ids.size(); ++i) CHECK(furthest(world_of(document, ids[i]), worlds[i]) < 2e-5f);
        const std::string after = state_of(document);
        document.undo();
        CHECK((state_of(document) == before));
        document.redo();
        CHECK((state_of(document) == after));
        return made;
    };
    // Below the scene: the middle of their positions, or of their bounds; nothing is turned or scaled again.
    const EntryId pair = grouped({ids[1], ids[2]});
    CHECK(middle(pair) == glm::vec3(2, 2, 0));
    CHECK(document.at(ids[1]).object()->rotation_deg == glm::vec3(10, 20, 30));
    CHECK(document.at(ids[2]).object()->rotation_deg == glm::vec3(721, 0, 0));
    const EntryId drawn = grouped({ids[4]}, {{-40, 7, 0}, {-20, 10, 3}});
    CHECK(middle(drawn) == glm::vec3(-30, 8.5f, 1.5f));
    // Below a parent that is turned and scaled, a group in a group among them.
    reparent(document, {pair, ids[3]}, ids[0]);
    const EntryId inner = grouped({pair, ids[3]});
    CHECK(document.at(inner).parent == ids[0]);
    CHECK(glm::length(middle(inner) - 0.5f * (middle(pair) + middle(ids[3]))) < 1e-5f);
    const EntryId deeper = grouped({ids[2]});
    CHECK(document.at(deeper).parent == pair);
    CHECK(glm::length(middle(deeper) - middle(ids[2])) < 1e-5f);
    // From several parents: below the scene.
    const EntryId all = grouped({ids[3], ids[4]});
    CHECK(document.at(all).parent == root_entry);
    CHECK(glm::length(middle(all) - 0.5f * (middle(ids[3]) + middle(ids[4]))) < 1e-5f);
    CHECK(names_of(document, {pair, drawn, inner, deeper, all}) ==
          Names{"group", "group 2", "group 3", "group 4", "group 5"});
}

TEST_CASE("what changes nothing is no step; what is locked takes no children; groups hold objects alone") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b"});
    const EntryId light = add_light(document, {});
    set_knobs(document, {{"bloom.method", "none"}}, 1);
    set_hidden(document, {ids[0]}, true);
    set_locked(document, {ids[1]}, true);
    const size_t steps = document.done();
    set_knobs(document, {{"bloom.method", "none"}}, 2);
    set_hidden(document, {ids[0]}, true);
    place(document, ids[0], placement_of(*document.at(ids[0]).object()));
    CHECK(rename(document, ids[0], "a") == "");
    CHECK(document.done() == steps);
    CHECK(reparent(document, {ids[0]}, ids[1]) == "the parent is locked");
    CHECK(remove(document, {root_entry}).find("belong to the scene") != std::string::npos);
    CHECK(document.done() == steps);
    const EntryId made = group(document, {ids[0], light, ids[1]}, "g");
    CHECK(names_of(document, document.at(made).children) == Names{"a"});
    CHECK(document.at(light).parent == root_entry);
    CHECK(group(document, {light}, "none") == no_entry);
}

TEST_CASE(
    "a new step takes the way forward away; one that is begun ends the one before; a cancelled one leaves all free") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"a", "b"});
    document.undo();
    rename(document, ids[0], "c");
    CHECK_FALSE(document.redo());
    CHECK(document.done() == 2);
    document.begin("first");
    document.edit(ids[0]).object()->position.x = 1;
    document.begin("second");
    document.edit(ids[0]).object()->position.x = 2;
    document.commit();
    document.undo();
    CHECK(document.at(ids[0]).object()->position.x == 1);
    document.begin("third");
    document.edit(ids[0]).object()->position.x = 3;
    document.cancel();
    place(document, ids[0], {{4, 0, 0}, {}, glm::vec3(1)});
    document.undo();
    CHECK(document.at(ids[0]).object()->position.x == 1);
    const uint64_t state = document.state();
    document.undo();
    document.redo();
    CHECK(document.state() == state);
    document.take_changes();
    place(document, ids[0], {{5, 0, 0}, {}, glm::vec3(1)});
    CHECK(document.take_changes().entries == std::vector<EntryId>{ids[0]});
    place(document, ids[0], {{6, 0, 0}, {}, glm::vec3(1)});
    CHECK(document.take_changes().entries == std::vector<EntryId>{ids[0]});
    CHECK(document.take_changes().entries.empty());
}

TEST_CASE("names are free again when their object is renamed, deleted or undone") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"lamp", "lamp", "lamp"});
    CHECK(names_of(document, ids) == Names{"lamp", "lamp 2", "lamp 3"});
    CHECK(names_of(document, duplicate(document, {ids[1]})) == Names{"lamp 4"});
    rename(document, ids[0], "sun");
    CHECK_FALSE(document.has_name("lamp"));
    CHECK(free_name(document, "lamp") == "lamp");
    document.undo();
    CHECK(document.has_name("lamp"));
    CHECK_FALSE(document.has_name("sun"));
    CHECK(free_name(document, "lamp 2", "lamp 2") == "lamp 2");
    CHECK(free_name(document, "lamp 2") == "lamp 5");
    remove(document, {ids[2]});
    CHECK_FALSE(document.has_name("lamp 3"));
}

TEST_CASE("the tree's rows: in order, below what is unfolded, with a model's nodes; found by all words, case aside") {
    Document document;
    const std::vector<EntryId> ids = add_all(document, {"Red Lamp", "lamp", "cup"});
    const EntryId child = add_object(document, named("red cup"), ids[0]);
    Tree tree;
    tree.node_count = [&](EntryId id) { return size_t(id == ids[1] ? 3 : id == ids[2] ? 1 : 0); };
    const auto shown = [&] {
        Names all;
        for (const TreeRow& row : tree.rows(document))
            all.push_back(fmt::format("{}{}{}", row.depth, document.at(row.id).name(), row.node < 0 ? "" : "*"));
        return all;
    };
    CHECK(shown() == Names{"0Red Lamp", "0lamp", "0cup"});
    CHECK(tree.rows(document)[0].has_children);
    CHECK(tree.rows(document)[1].has_children);
    CHECK_FALSE(tree.rows(document)[2].has_children);
    tree.show(document, child);
    CHECK_FALSE(tree.is_unfolded(child));
    for (const EntryId id : ids) tree.unfold(id, true);
    CHECK(shown() == Names{"0Red Lamp", "1red cup", "0lamp", "1lamp*", "1lamp*", "1lamp*", "0cup"});
    CHECK(names_of(document, tree.between(ids[2], child)) == Names{"cup", "lamp", "red cup"});
    CHECK(tree.between(12345, ids[1]) == std::vector<EntryId>{ids[1]});
    CHECK(tree.between(ids[1], 12345) == std::vector<EntryId>{ids[1]});
    rename(document, ids[2], "mug");
    CHECK(shown().back() == "0mug");
    document.undo();
    CHECK(shown().back() == "0cup");
    reparent(document, {ids[2]}, root_entry, 0);
    CHECK(shown()[0] == "0cup");
    document.undo();
    CHECK(shown()[0] == "0Red Lamp");
    document.redo();
    tree.search("RED lamp");
    CHECK(shown() == Names{"0Red Lamp"});
    tree.search("red");
    CHECK(shown() == Names{"0Red Lamp", "0red cup"});
    rename(document, child, "blue cup");
    CHECK(shown() == Names{"0Red Lamp"});
    document.undo();
    CHECK(shown() == Names{"0Red Lamp", "0red cup"});
}

TEST_CASE("files: the camera of the window, an ending of their own, includes of another folder") {
    const FileFolder folder;
    Document document;
    add_all(document, {"a"});
    SceneStore store;
    Camera camera;
    camera.position = {1, 2, 3};
    store.camera = camera;
    CHECK(store.save_as(document, folder.path / "plain") == "");
    CHECK(store.path == folder.path / "plain.json");
    CHECK(read_scene(store.path).camera.position == glm::vec3(1, 2, 3));
    CHECK_FALSE(store.changed_on_disk());
    add_object(document, named("b"));
    store.save(document);
    CHECK_FALSE(store.changed_on_disk());

    add_object(document, named("c"));
    CHECK(store.autosave(document));
    document.undo();
    CHECK_FALSE(store.has_unsaved(document));
    store.forget_autosave();
    CHECK_FALSE(store.autosave(document));

    write_file(folder.path / "part.json", R"({"objects": [{}, {"name": "p"}], "lights": [{"type": "point"}]})");
    write_file(folder.path / "whole.json",
               R"({"include": ["part.json"], "objects": [{}], "lights": [{"type": "point"}, {"type": "point"}]})");
    Document whole_scene = store.open(folder.path / "whole.json");
    int included = 0;
    for (const EntryId id : with_children(whole_scene, root_entry)) included += whole_scene.at(id).included;
    CHECK(included == 3);
    const EntryId copy = duplicate(whole_scene, {whole_scene.at(root_entry).children[1]}).at(0);
    CHECK_FALSE(whole_scene.at(copy).included);
    std::filesystem::create_directory(folder.path / "sub");
    CHECK(store.save_as(whole_scene, folder.path / "sub" / "whole.json").find("another folder") != std::string::npos);
    CHECK(read_scene(folder.path / "sub" / "whole.json").objects.size() == 4);

    // Values that the format lacks are not written.
    const std::string before = read_file(store.path);
    whole_scene.begin("break");
    whole_scene.edit(copy).object()->scale = glm::vec3(0);
    whole_scene.commit();
    CHECK_THROWS_AS(store.save(whole_scene), InputError);
    CHECK(read_file(store.path) == before);
}
