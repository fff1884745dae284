// Reader for scene file keys. Errors name file, line and key.
#pragma once
#include <set>

#include "common/base/error.h"
#include "common/scene/json_lines.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

using nlohmann::json;

/// JSON object whose keys are read one by one; done() rejects the remaining ones.
class KeyReader {
  public:
    KeyReader(const JsonWithLines& source, const json& object, std::string pointer)
        : source_(source), object_(object), pointer_(std::move(pointer)) {
        if (!object.is_object()) throw InputError("{} must be an object {{ }}", source.where(pointer_));
    }

    void number(const char* key, float& value, double lower, double upper) {
        const json* given = find(key);
        if (!given) return;
        if (!given->is_number()) refuse(key, "must be a number");
        const double number = given->get<double>();
        if (!(number >= lower && number <= upper))
            refuse(key, fmt::format("is {}, expected {} to {}", given->dump(), text(lower), text(upper)));
        value = static_cast<float>(number);
    }
    void angle(const char* key, float& value_rad, double lower_deg, double upper_deg) {
        float degrees = glm::degrees(value_rad);
        number(key, degrees, lower_deg, upper_deg);
        value_rad = glm::radians(degrees);
    }
    void vector(const char* key, glm::vec3& value, double lower = -1e9, double upper = 1e9) {
        const json* given = find(key);
        if (!given) return;
        if (!given->is_array() || given->size() != 3) refuse(key, "must be three numbers [x, y, z]");
        for (int i = 0; i < 3; ++i) {
            const json& item = (*given)[static_cast<size_t>(i)];
            if (!item.is_number()) refuse(key, "must be three numbers [x, y, z]");
            const double number = item.get<double>();
            if (!(number >= lower && number <= upper))
                refuse(key, fmt::format("holds {}, expected {} to {}", item.dump(), text(lower), text(upper)));
            value[i] = static_cast<float>(number);
        }
    }
    void string(const char* key, std::string& value) {
        const json* given = find(key);
        if (!given) return;
        if (!given->is_string()) refuse(key, "must be a text in quotes");
        value = given->get<std::string>();
    }
    void boolean(const char* key, bool& value) {
        const json* given = find(key);
        if (!given) return;
        if (!given->is_boolean()) refuse(key, "must be true or false");
        value = given->get<bool>();
    }
    const json* find(const char* key) {
        known_.insert(key);
        const auto it = object_.find(key);
        return it == object_.end() ? nullptr : &*it;
    }
    std::string at(const std::string& key) const { return pointer_ + "/" + pointer_step(key); }
    [[noreturn]] void refuse(const std::string& key, const std::string& why) const {
        throw InputError("{} {}", source_.where(at(key)), why);
    }
    void done() const {
        for (const auto& [key, value] : object_.items()) {
            if (known_.count(key)) continue;
            std::string names;
            for (const std::string& name : known_) names += (names.empty() ? "" : ", ") + name;
            throw InputError("{} is unknown here; known: {}", source_.where(at(key)), names);
        }
    }

  private:
    static std::string text(double value) { return json(value).dump(); }
    const JsonWithLines& source_;
    const json& object_;
    std::string pointer_;
    std::set<std::string> known_;
};

template <class F>
void each(const JsonWithLines& source, KeyReader& parent, const char* key, F read) {
    const json* list = parent.find(key);
    if (!list) return;
    if (!list->is_array()) parent.refuse(key, "must be a list [ ]");
    for (size_t i = 0; i < list->size(); ++i) {
        const std::string pointer = fmt::format("{}/{}", parent.at(key), i);
        read(KeyReader(source, (*list)[i], pointer), pointer);
    }
}

void read_camera(KeyReader r, Camera& camera);
Light read_light(KeyReader r, bool& hidden);
SceneObject read_object(const JsonWithLines& source, KeyReader r, const std::string& pointer);

Environment read_environment(const JsonWithLines& source, KeyReader& scene);

SceneMusic read_music(const JsonWithLines& source, KeyReader& scene);

}  // namespace lightwalk
