// Shader macros and include substitutions.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "common/base/files.h"

namespace lightwalk {

/// True for a letter, then letters, digits and _.
bool is_macro_word(std::string_view name);
inline constexpr const char* a_macro_word = "a name is a letter, then letters, digits and _: it becomes a macro";

/// Macros, substituted files and a hash of both. Copy-on-write.
class Macros {
  public:
    using Texts = std::map<std::string, std::string>;
    Macros() = default;
    Macros(std::initializer_list<std::pair<const std::string, std::string>> list) {
        for (const auto& [name, value] : list) set(name, value);
    }
    void set(const std::string& name, const std::string& value) { put(own().values, name, value); }
    /// Includes shaders/`other`, possibly of a later chapter, wherever shaders/`file` is included.
    Macros& replace_file(const std::string& file, const std::string& other) {
        put(own().files, file, other);
        return *this;
    }
    void add(const Macros& other) {
        for (const auto& [name, value] : other.values()) set(name, value);
        for (const auto& [file, replacement] : other.files()) replace_file(file, replacement);
    }
    const Texts& files() const { return texts().files; }
    const Texts& values() const { return texts().values; }
    uint64_t hash() const { return hash_; }
    bool operator==(const Macros& other) const {
        return hash_ == other.hash_ && (both_ == other.both_ || texts() == other.texts());
    }
    auto begin() const { return values().begin(); }
    auto end() const { return values().end(); }

  private:
    struct Both {
        Texts values, files;
        bool operator==(const Both&) const = default;
    };
    const Both& texts() const {
        static const Both no_texts;
        return both_ ? *both_ : no_texts;
    }
    Both& own() {
        if (!both_ || both_.use_count() > 1) both_ = std::make_shared<Both>(texts());
        return *both_;
    }
    void put(Texts& texts, const std::string& name, const std::string& value) {
        auto [it, added] = texts.try_emplace(name, value);
        if (!added) {
            hash_ -= of(name, it->second);
            it->second = value;
        }
        hash_ += of(name, value);
    }
    // MurmurHash3's finalizer, variant 13 (D. Stafford, 2011): without it, changes of two macros can cancel.
    static uint64_t of(const std::string& name, const std::string& value) {
        uint64_t hash = hash_bytes(value, hash_bytes(name + "="));
        hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
        return hash ^ hash >> 31;
    }
    std::shared_ptr<Both> both_;
    uint64_t hash_ = 0;
};

}  // namespace lightwalk
