// Macros for shaders, and substitutes for included files.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>

#include "common/base/files.h"

namespace lightwalk {

/// Names and values, substituted files, and a hash of both that identifies a variant of a pipeline. Copies share their
/// texts until one of them changes.
class Macros {
  public:
    using Texts = std::map<std::string, std::string>;
    Macros() = default;
    Macros(std::initializer_list<std::pair<const std::string, std::string>> list) {
        for (const auto& [name, value] : list) set(name, value);
    }
    void set(const std::string& name, const std::string& value) { put(own().values, name, value); }
    /// Reads shaders/`other`, which may be a later chapter's, where shaders/`file` is included.
    Macros& replace_file(const std::string& file, const std::string& other) {
        put(own().files, file, other);
        return *this;
    }
    /// Adds all of `other`; its values take precedence.
    void add(const Macros& other) {
        for (const auto& [name, value] : other.values()) set(name, value);
        for (const auto& [file, replacement] : other.files()) replace_file(file, replacement);
    }
    const Texts& files() const { return texts().files; }
    const Texts& values() const { return texts().values; }
    uint64_t hash() const { return hash_; }
    auto begin() const { return values().begin(); }
    auto end() const { return values().end(); }

  private:
    struct Both {
        Texts values, files;
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
    // Mixed once more (D. Stafford's variant 13 of MurmurHash3's finalizer, 2011): the hash of a short text alone
    // differs from another's by so little that the changes of two macros can cancel in the sum.
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
