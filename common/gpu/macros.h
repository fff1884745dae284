// Shader macros and include substitutions.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace lightwalk {

/// True for a letter, then letters, digits and _.
bool is_macro_word(std::string_view name);
inline constexpr const char* a_macro_word = "a name is a letter, then letters, digits and _: it becomes a macro";

/// Macros, substituted files and a hash of both. Copy-on-write.
class Macros {
  public:
    using Texts = std::map<std::string, std::string>;
    Macros() = default;
    Macros(std::initializer_list<std::pair<const std::string, std::string>> list);
    void set(const std::string& name, const std::string& value) { put(own().values, name, value); }
    /// Includes shaders/`other`, possibly of a later chapter, wherever shaders/`file` is included.
    Macros& replace_file(const std::string& file, const std::string& other);
    void add(const Macros& other);
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
    const Both& texts() const;
    Both& own();
    void put(Texts& texts, const std::string& name, const std::string& value);
    std::shared_ptr<Both> both_;
    uint64_t hash_ = 0;
};

}  // namespace lightwalk
