#include "common/gpu/macros.h"

#include "common/base/files.h"

namespace lightwalk {
namespace {

// MurmurHash3's finalizer, variant 13 (D. Stafford, 2011): without it, changes of two macros can cancel.
uint64_t hash_of(const std::string& name, const std::string& value) {
    uint64_t hash = hash_bytes(value, hash_bytes(name + "="));
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
    return hash ^ hash >> 31;
}

}  // namespace

Macros::Macros(std::initializer_list<std::pair<const std::string, std::string>> list) {
    for (const auto& [name, value] : list) set(name, value);
}

Macros& Macros::replace_file(const std::string& file, const std::string& other) {
    put(own().files, file, other);
    return *this;
}

void Macros::add(const Macros& other) {
    for (const auto& [name, value] : other.values()) set(name, value);
    for (const auto& [file, replacement] : other.files()) replace_file(file, replacement);
}

const Macros::Both& Macros::texts() const {
    static const Both no_texts;
    return both_ ? *both_ : no_texts;
}

Macros::Both& Macros::own() {
    if (!both_ || both_.use_count() > 1) both_ = std::make_shared<Both>(texts());
    return *both_;
}

void Macros::put(Texts& texts, const std::string& name, const std::string& value) {
    auto [it, added] = texts.try_emplace(name, value);
    if (!added) {
        hash_ -= hash_of(name, it->second);
        it->second = value;
    }
    hash_ += hash_of(name, value);
}

}  // namespace lightwalk
