// Values of a study file, checked one by one.
#pragma once
#include <algorithm>
#include <initializer_list>

#include "common/base/error.h"
#include "common/scene/json_lines.h"

namespace lightwalk {

/// A value of the file with its position: errors name file, line and key.
class JsonNode {
  public:
    JsonNode(const JsonWithLines& source, const nlohmann::json& of, std::string pointer)
        : value(of), source_(source), pointer_(std::move(pointer)) {}

    const nlohmann::json& value;

    [[noreturn]] void refuse(const std::string& why) const {
        throw InputError(source_.where(pointer_) + (why[0] == ':' ? "" : " ") + why);
    }
    void expect(bool right, const char* what) const {
        if (!right) refuse(std::string("is ") + value.dump() + ", expected " + what);
    }
    void expect_keys(std::initializer_list<const char*> known) const {
        expect(value.is_object(), "an object { }");
        std::string names;
        for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
        for (const auto& [key, ignored] : value.items())
            if (std::find(known.begin(), known.end(), key) == known.end())
                (*this)[key].refuse("is unknown here; known: " + names);
    }
    bool has(const std::string& key) const { return value.contains(key); }
    JsonNode operator[](const std::string& key) const {
        if (!has(key)) refuse("has no \"" + key + "\"");
        return {source_, value.at(key), pointer_ + "/" + key};
    }
    std::vector<JsonNode> items() const {
        expect(value.is_array() && !value.empty(), "a list [ ] with something in it");
        std::vector<JsonNode> nodes;
        for (size_t i = 0; i < value.size(); ++i)
            nodes.emplace_back(source_, value[i], pointer_ + "/" + std::to_string(i));
        return nodes;
    }
    std::string text() const {
        expect(value.is_string() && !value.get_ref<const std::string&>().empty(), "a text in quotes");
        return value.get<std::string>();
    }
    std::string one_of(std::initializer_list<const char*> words, const char* what) const {
        expect(std::find(words.begin(), words.end(), text()) != words.end(), what);
        return text();
    }

  private:
    const JsonWithLines& source_;
    std::string pointer_;
};

}  // namespace lightwalk
