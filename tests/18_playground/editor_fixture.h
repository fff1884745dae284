// Shared by the tests of the editor: random commands, a document as one text.
#pragma once
#include <fmt/core.h>

#include <chrono>
#include <ctime>

#include "18_playground/commands.h"
#include "18_playground/saving.h"
#include "common/base/error.h"
#include "common/base/files.h"
#include "common/base/sanitized.h"
#include "common/check/check.h"
#include "tests/catch.h"
#include "tests/common/file_fixture.h"

namespace lightwalk {

inline double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of this thread alone, without other processes.
inline double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

/// Everything of a document but its steps: ids, order, parents, switches, and every number to the bit.
inline std::string state_of(const Document& document) {
    std::string text = scene_text(exported(document).scene);
    for (const EntryId id : with_children(document, root_entry)) {
        const Entry& entry = document.at(id);
        text += fmt::format("{} below {}{}{}\n", id, entry.parent, entry.hidden ? " hidden" : "",
                            entry.locked ? " locked" : "");
        if (const Light* light = entry.light())
            text += fmt::format("{:a} {:a} {:a}\n", light->direction.x, light->inner_rad, light->outer_rad);
    }
    return text;
}

inline SceneObject named(const std::string& name, const std::string& model = "") {
    SceneObject object;
    object.name = name;
    object.model = model;
    return object;
}

inline std::vector<EntryId> add_all(Document& document, const std::vector<std::string>& names) {
    std::vector<EntryId> ids;
    for (const std::string& name : names) ids.push_back(add_object(document, named(name)));
    return ids;
}

/// One command out of all, with arbitrary arguments.
inline void random_command(Document& document, Random& random) {
    const std::vector<EntryId> all = with_children(document, root_entry);
    const auto any = [&] { return all[static_cast<size_t>(random.uniform(0, double(all.size()) - 0.001))]; };
    const auto some = [&] {
        std::vector<EntryId> ids;
        for (int i = 0; i <= int(random.uniform(0, 5)); ++i) ids.push_back(any());
        return ids;
    };
    const auto number = [&] { return static_cast<float>(random.uniform(-100, 100)); };
    const glm::vec3 v(number(), number(), number());
    static const char* const names[] = {
        "a", "lamp", "a \"quoted\" name", "two\nlines", "\xff\xfe not UTF-8", "ü→漢", "", "lamp 2", "\\"};
    switch (static_cast<int>(random.uniform(0, 15))) {
        case 0:
        case 1:
            add_object(document, named(names[size_t(random.uniform(0, 8.99))]),
                       random.uniform(0, 1) < 0.5 && document.at(all.back()).object() ? all.back() : root_entry);
            break;
        case 2:
            add_light(document, {.kind = Light::Kind(int(random.uniform(0, 2.99))), .position = v});
            break;
        case 3:
            scatter(document, {{-1, 0, -1}, {1, 1, 1}}, 3, unsigned(random.uniform(0, 1e6)));
            break;
        case 4:
            if (document.size() > 60) remove(document, some());
            break;
        case 5:
            if (document.size() < 300) duplicate(document, some());
            break;
        case 6:
            group(document, some(), names[size_t(random.uniform(0, 8.99))]);
            break;
        case 7:
        case 8:
            reparent(document, some(), any(), random.uniform(0, 1) < 0.5 ? SIZE_MAX : size_t(random.uniform(0, 9)));
            break;
        case 9:
            rename(document, any(), names[size_t(random.uniform(0, 8.99))]);
            break;
        case 10:
            set_hidden(document, some(), random.uniform(0, 1) < 0.5);
            break;
        case 11:
            set_locked(document, some(), random.uniform(0, 1) < 0.2);
            break;
        case 12:
            place(document, any(), {v, 3.0f * v, random.uniform(0, 1) < 0.2 ? glm::vec3(0) : glm::vec3(number(), 1, 2)},
                  random.uniform(0, 1) < 0.5 ? 7 : 0);
            break;
        case 13:
            set_knobs(document, {{"bloom.method", random.uniform(0, 1) < 0.5 ? "none" : "kawase"}}, 9);
            break;
        default:
            if (random.uniform(0, 1) < 0.5) document.undo();
            if (random.uniform(0, 1) < 0.5) document.redo();
    }
}

}  // namespace lightwalk
