// [minimal]
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

struct Thing {  // a line of the tree, as a value
    std::string name;
    int parent;
    float x;
};
using Version = std::shared_ptr<const Thing>;  // null: it is not there
struct Change {
    int id;
    Version before, after;
};
struct Step {
    std::string name;
    int gesture;  // steps of one drag have the same, above 0
    std::vector<Change> changes;
};

struct Editor {
    std::map<int, Version> things;  // by id; no id is ever used again
    std::vector<Step> done, undone;
    void put(int id, const Version& version) { version ? void(things[id] = version) : void(things.erase(id)); }
    void run(Step step) {
        for (Change& c : step.changes) c.before = things.count(c.id) ? things[c.id] : nullptr, put(c.id, c.after);
        const bool joins = step.gesture && undone.empty() && !done.empty() && done.back().gesture == step.gesture;
        undone.clear();
        if (!joins) return done.push_back(step);
        for (size_t i = 0; i < step.changes.size(); ++i) done.back().changes[i].after = step.changes[i].after;
    }
    void undo() {
        for (const Change& c : done.back().changes) put(c.id, c.before);
        undone.push_back(done.back());
        done.pop_back();
    }
    void redo() {
        for (const Change& c : undone.back().changes) put(c.id, c.after);
        done.push_back(undone.back());
        undone.pop_back();
    }
};

int main() {
    Editor editor;
    const auto thing = [](const char* name, int parent, float x) { return Version(new Thing{name, parent, x}); };
    editor.run({"add", 0, {{1, {}, thing("table", 0, 0)}, {2, {}, thing("cup", 1, 0)}}});
    for (int i = 1; i <= 100; ++i) editor.run({"drag", 7, {{2, {}, thing("cup", 1, 0.01f * float(i))}}});
    editor.run({"delete", 0, {{1, {}, nullptr}, {2, {}, nullptr}}});
    std::printf("steps %zu things %zu\n", editor.done.size(), editor.things.size());
    editor.undo();  // both come back, with their ids
    std::printf("restored %zu place %g\n", editor.things.size(), double(editor.things[2]->x));
    editor.undo();  // the whole drag
    std::printf("before_the_drag %g\n", double(editor.things[2]->x));
}
// [/minimal]
