// Autosaves: two editors of one scene, editors ended by a crash, and autosaves older than the scene.
#include "editor_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

struct Open {
    SceneStore store;
    Document document;
    explicit Open(const fs::path& file) { document = store.open(file); }
    Said change(const std::string& name) {
        Said said;
        add_object(document, named(name));
        CHECK(store.autosave(document, &said));
        return said;
    }
};

fs::path write_scene(const FileFolder& folder) {
    write_file(folder.path / "scene.json", R"({"objects": [{"name": "first"}]})");
    return folder.path / "scene.json";
}

}  // namespace

TEST_CASE("a second editor of a scene says so, and neither offers nor touches the first one's autosave") {
    const FileFolder folder;
    const fs::path file = write_scene(folder);
    Open first(file);
    CHECK(first.change("of the first") == "");
    const fs::path live = first.store.autosave_file();
    const std::string kept = read_file(live);
    {
        Open second(file);
        Said said;
        CHECK_FALSE(second.store.has_recovery(&said));
        CHECK(said == "scene.json is open in another editor, too");
        CHECK_THROWS_AS(second.store.recover(), InputError);
        CHECK(second.store.set_aside().empty());
        second.store.forget_recovery();  // "throw away"
        CHECK(second.change("of the second") ==
              "scene.json is open in another editor: this one's autosave is scene.json.2.unsaved");
        const fs::path own = second.store.autosave_file();
        CHECK(own != live);
        CHECK(second.change("more") == "");
        CHECK(parse_scene(read_file(own), file).objects.size() == 3);
        second.store.save(second.document);
        CHECK_FALSE(fs::exists(own));
        second.change("not saved");
        second.store.forget_autosave();
        CHECK_FALSE(fs::exists(own));
    }
    CHECK(read_file(live) == kept);
    first.change("more");
    CHECK(first.store.autosave_file() == live);
    first.store.save(first.document);
    CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}

TEST_CASE("after both editors of a scene have crashed, what each one had is offered, and one editor is asked") {
    const FileFolder folder;
    const fs::path file = write_scene(folder);
    {
        Open first(file), second(file);
        first.change("of the first");
        second.change("of the second");
    }
    Open next(file);
    REQUIRE(next.store.has_recovery());
    CHECK_FALSE(SceneStore(Open(file).store).recover().at(root_entry).children.empty());  // the second one's
    Document recovered = next.store.recover();
    CHECK(recovered.has_name("of the first"));
    add_object(recovered, named("more"));
    CHECK(next.store.autosave(recovered));
    CHECK(next.store.autosave_file() == file.string() + ".unsaved");
    next.store.save(recovered);
    Open last(file);
    fs::last_write_time(file.string() + ".2.unsaved", fs::last_write_time(file) + std::chrono::seconds(1));
    REQUIRE(last.store.has_recovery());
    CHECK(last.store.recover().has_name("of the second"));
}

TEST_CASE("an autosave that is older than its scene is not offered, and keeps another name when the next one comes") {
    const FileFolder folder;
    const fs::path file = write_scene(folder);
    Open(file).change("left");
    const fs::path left = file.string() + ".unsaved";
    const std::string old = read_file(left);
    fs::last_write_time(left, fs::last_write_time(file) - std::chrono::hours(1));
    Open next(file);
    Said said;
    CHECK_FALSE(next.store.has_recovery(&said));
    CHECK(said == "");
    CHECK(next.change("new") == "an autosave that was left is kept as scene.json.unsaved.1");
    CHECK(read_file(left.string() + ".1") == old);
    CHECK(parse_scene(read_file(left), file).objects.at(1).name == "new");
    CHECK(next.change("newer") == "");
    next.store.save(next.document);
    CHECK_FALSE(fs::exists(left));
    CHECK(read_file(left.string() + ".1") == old);
}

TEST_CASE(
    "the autosave of a scene of the course's tree lies in the person's state folder, and is offered after a crash") {
    const FileFolder folder;
    setenv("XDG_STATE_HOME", folder.path.c_str(), 1);
    const fs::path file = course_root() / "assets" / "scenes" / "workbench.json";
    const auto beside = [&] {
        return std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator());
    };
    const auto files = beside();
    {
        Open crashed(file);
        crashed.change("not saved");
        CHECK(crashed.store.autosave_file().string().starts_with(folder.path.string()));
    }
    CHECK(beside() == files);
    Open next(file);
    CHECK(next.store.has_recovery());
    next.store.recover();
    CHECK(parse_scene(read_file(next.store.autosave_file()), file).objects.back().name == "not saved");
    next.store.forget_autosave();
    Open last(file);
    CHECK_FALSE(last.store.has_recovery());
    unsetenv("XDG_STATE_HOME");
}
