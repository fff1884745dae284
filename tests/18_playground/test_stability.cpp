// Saving where it is hard: killed at any moment, a file that others change. Full disks and links are in test_files.cpp.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>

#include "editor_fixture.h"

using namespace lightwalk;
namespace fs = std::filesystem;

namespace {

Document small_scene(int objects) {
    Document document;
    document.begin("make");
    for (int i = 0; i < objects; ++i) document.add(root_entry, {.what = named(fmt::format("object {}", i))});
    document.commit();
    return document;
}

std::ptrdiff_t files_in(const fs::path& folder) { return std::distance(fs::directory_iterator(folder), {}); }

// Of a whole file.
int number_in(const fs::path& file) {
    const SceneFile back = parse_scene(read_file(file), file);
    REQUIRE(back.objects.size() == 300);
    return std::stoi(back.knobs.at("number"));
}

// A process that writes scenes with the numbers from `first` on, and says which one is written. It is killed at a random
// moment; `within` a write: on a busy machine few of the moments of the clock are. The last number that it said.
int kill_while_it_writes(const fs::path& folder, Random& random, bool within, int first,
                         const std::function<void(SceneStore&, Document&)>& write_scene) {
    int told[2];
    REQUIRE(pipe(told) == 0);
    const pid_t child = fork();
    if (child == 0) {
        close(told[0]);
        Document document = small_scene(300);
        SceneStore store;
        store.path = folder / "scene.json";
        for (int number = first;; ++number) {
            set_knobs(document, {{"number", std::to_string(number)}}, 0);
            write_scene(store, document);
            if (write(told[1], &number, sizeof number) != sizeof number) _exit(1);
        }
    }
    close(told[1]);
    int number = 0;
    if (read(told[0], &number, sizeof number) != sizeof number) FAIL("it never saved");
    for (int polls = 0; within && files_in(folder) == 1 && polls < 20000; ++polls) {}
    if (within) {  // 1 to 200 µs, as often below 14 as above: a sleep takes 50 at least, too long for a fast disk
        const auto until =
            std::chrono::steady_clock::now() + std::chrono::nanoseconds(int(std::pow(10, random.uniform(3, 5.3))));
        while (std::chrono::steady_clock::now() < until) {}
    } else {
        usleep(static_cast<useconds_t>(random.uniform(0, 6000)));
    }
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    int last_told = number;
    while (read(told[0], &number, sizeof number) == sizeof number) last_told = number;
    close(told[0]);
    return last_told;
}

}  // namespace

TEST_CASE("killed at 200 random moments of saving: the file is whole, and never older than the last save that was told",
          "[18.killed]") {
    FileFolder folder;
    const fs::path file = folder.path / "scene.json";
    Random random(200);
    int last_told = 0, killed_within = 0;
    for (int round = 0; round < 200; ++round) {
        last_told = kill_while_it_writes(folder.path, random, round % 2, last_told + 1,
                                         [](SceneStore& store, Document& document) { store.save(document); });
        const int saved = number_in(file);
        REQUIRE((saved == last_told || saved == last_told + 1));
        killed_within += saved != last_told || files_in(folder.path) > 1;
        for (const auto& other : fs::directory_iterator(folder.path))
            if (other.path() != file) fs::remove(other.path());
    }
    fmt::print("of 200 kills {} came while it wrote\n", killed_within);
    CHECK(killed_within > 20);
}

TEST_CASE("killed at 60 random moments of saving by itself: what it leaves is whole, and is offered", "[18.killed]") {
    Random random(60);
    int killed_within = 0;
    for (int round = 0; round < 60; ++round) {
        FileFolder folder;
        const int told = kill_while_it_writes(folder.path, random, round % 2, 1,
                                              [](SceneStore& store, Document& document) { store.autosave(document); });
        const fs::path left = folder.path / "scene.json.unsaved", fresh = left.string() + ".new";
        const int saved = number_in(left);
        REQUIRE((saved == told || saved == told + 1));
        if (fs::exists(fresh)) REQUIRE(number_in(fresh) == told + 1);
        killed_within += saved != told || files_in(folder.path) > 1;
        SceneStore next;
        next.path = folder.path / "scene.json";
        REQUIRE(next.has_recovery());
    }
    fmt::print("of 60 kills {} came while it wrote\n", killed_within);
    CHECK(killed_within > 6);
}

TEST_CASE("a file that somebody else has written is noticed; includes are kept while nothing of them is changed") {
    FileFolder folder;
    write_file(
        folder.path / "lights.json",
        R"({"objects": [{"name": "table"}, {"name": "leg", "parent": "table"}], "lights": [{"type": "point"}]})");
    const fs::path file = folder.path / "scene.json";
    write_file(file, R"({"include": ["lights.json"], "objects": [{"name": "cup", "parent": "table"}, {"name": "lamp"}],
        "lights": [{"type": "spot", "direction": [0, -1, 0.3]}]})");
    SceneStore store;
    Document document = store.open(file);
    CHECK_FALSE(store.has_unsaved(document));
    const auto find = [&](const std::string& name) {
        for (const EntryId id : with_children(document, root_entry))
            if (document.at(id).name() == name) return id;
        return no_entry;
    };
    CHECK(document.at(find("leg")).included);
    CHECK_FALSE(document.at(find("cup")).included);
    place(document, find("cup"), {{0.1f, 1, 0}, {}, glm::vec3(1)});
    CHECK(store.has_unsaved(document));
    CHECK_FALSE(store.changed_on_disk());
    CHECK(store.save(document) == "");
    const std::string text = read_file(file);
    CHECK(text.find("lights.json") != std::string::npos);
    CHECK(text.find("leg") == std::string::npos);
    CHECK(text.find("0.1,") != std::string::npos);
    SceneFile back = read_scene(file);
    CHECK(back.objects.size() == 4);
    CHECK(back.lights.size() == 2);
    CHECK(store.text(document) == text);

    write_file(file, "{}");
    CHECK(store.changed_on_disk());
    place(document, find("table"), {{0, 1, 0}, {}, glm::vec3(1)});
    CHECK(store.save(document).find("includes") != std::string::npos);
    CHECK(read_file(file).find("lights.json") == std::string::npos);
    CHECK(read_scene(file).objects.size() == 4);
}

TEST_CASE("what is read and written again is the same text") {
    Random random(9);
    Document document;
    for (int i = 0; i < 3000; ++i) random_command(document, random);
    for (int i = 0; i < 200; ++i)
        add_light(document, {.kind = Light::Kind::spot,
                             .direction = random.direction(),
                             .inner_rad = float(random.uniform(0, 1)),
                             .outer_rad = float(random.uniform(1, 3))});
    const std::string text = scene_text(exported(document).scene);
    Document again(parse_scene(text, "scene.json"));
    CHECK(scene_text(exported(again).scene) == text);
}

TEST_CASE("what is hidden and what is locked is so again after saving and opening, object or light") {
    const FileFolder folder;
    Document document = small_scene(4);
    const std::vector<EntryId> objects = document.at(root_entry).children;
    std::vector<EntryId> lights;
    for (int i = 0; i < 4; ++i) lights.push_back(add_light(document, {.kind = Light::Kind::point}));
    set_hidden(document, {objects[1], objects[3], lights[1], lights[3]}, true);
    set_locked(document, {objects[2], objects[3], lights[2], lights[3]}, true);
    SceneStore store;
    store.path = folder.path / "scene.json";
    store.save(document);
    Document opened = SceneStore().open(store.path);
    const std::vector<EntryId> entries = opened.at(root_entry).children;
    REQUIRE(entries.size() == 8);
    for (size_t i = 0; i < 8; ++i) {
        CHECK(opened.at(entries[i]).hidden == (i % 2 == 1));
        CHECK(opened.at(entries[i]).locked == (i % 4 >= 2));
    }
    CHECK(remove(opened, {entries[2]}) != "");
    set_locked(opened, {entries[2]}, false);
    CHECK(remove(opened, {entries[2]}) == "");
    CHECK(store.text(document) == read_file(store.path));
}
