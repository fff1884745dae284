// Macros for shaders, and substitutes for included files.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>

#include "common/base/files.h"

namespace lightwalk {

/// Names and values, substituted files, and a hash of both that identifies a variant of a pipeline.
class Macros {
  public:
    Macros() = default;
    Macros(std::initializer_list<std::pair<const std::string, std::string>> list) {
        for (const auto& [name, value] : list) set(name, value);
    }
    void set(const std::string& name, const std::string& value) {
        auto [it, added] = values_.try_emplace(name, value);
        if (!added) hash_ -= of(name, it->second), it->second = value;
        hash_ += of(name, value);
    }
    /// Reads shaders/`other`, which may be a later chapter's, where shaders/`file` is included.
    Macros& replace_file(const std::string& file, const std::string& other) {
        auto [it, added] = files_.try_emplace(file, other);
        if (!added) hash_ -= of(file, it->second), it->second = other;
        hash_ += of(file, other);
        return *this;
    }
    /// Adds all of `other`; its values take precedence.
    void add(const Macros& other) {
        for (const auto& [name, value] : other.values_) set(name, value);
        for (const auto& [file, replacement] : other.files_) replace_file(file, replacement);
    }
    const std::map<std::string, std::string>& files() const { return files_; }
    const std::map<std::string, std::string>& values() const { return values_; }
    uint64_t hash() const { return hash_; }
    auto begin() const { return values_.begin(); }
    auto end() const { return values_.end(); }

  private:
    // Mixed once more (D. Stafford's variant 13 of MurmurHash3's finalizer, 2011): the hash of a short text alone
    // differs from another's by so little that the changes of two macros can cancel in the sum.
    static uint64_t of(const std::string& name, const std::string& value) {
        uint64_t hash = hash_bytes(value, hash_bytes(name + "="));
        hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
        hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
        return hash ^ hash >> 31;
    }
    std::map<std::string, std::string> values_, files_;
    uint64_t hash_ = 0;
};

}  // namespace lightwalk
