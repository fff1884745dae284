// Knobs: module parameters, declared once for option, slider, scene file, study, and uniform or macro.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"
#include "common/gpu/macros.h"

namespace lightwalk {

class Module;

class KnobBase {
  public:
    /// Throws Failure, which names the statement `where`: a name that is no word or stands twice, no help.
    KnobBase(Module& owner, std::string name, std::string help, std::string unit, SourceLocation where);
    virtual ~KnobBase();
    KnobBase(const KnobBase&) = delete;

    /// Parses the text of --set, a scene file or a study. Throws InputError with the range or the names.
    virtual void set(const std::string& text) = 0;
    virtual std::string text() const = 0;
    virtual void reset() = 0;
    virtual void change_default(const std::string& text) = 0;  ///< sets the default and the value
    virtual nlohmann::json describe() const = 0;

    /// Accepted values and default, for --help: "{none,hard,pcf} (pcf)", "0..1 m (0.01)".
    virtual std::string usage() const = 0;

    virtual bool changed() const = 0;

    /// Adds macros of compiled-in knobs: for shadow.filter, SHADOW_FILTER, SHADOW_FILTER_PCF, …
    virtual void add_macros(Macros&) const {}

    /// Settings with a compiled variant each; empty for uniforms.
    virtual std::vector<std::string> variants() const { return {}; }

    /// Index into variants() of the current setting.
    virtual size_t variant() const { return 0; }

    /// Uniform value: up to four floats, or integers as bits; empty for macros.
    struct Numbers {
        std::array<float, 4> values{};
        size_t count = 0;
        const float* begin() const { return values.data(); }
        const float* end() const { return values.data() + count; }
    };
    virtual Numbers numbers() const { return {}; }
    virtual bool is_integer() const { return false; }

    std::string path() const;   ///< shadow.filter
    std::string macro() const;  ///< SHADOW_FILTER

    Module& owner;
    const std::string name, help, unit;
    bool pinned = false;     ///< set on the command line: overrides scene files
    bool preferred = false;  ///< its short name takes precedence over equal names in other modules
};

using KnobList = std::vector<KnobBase*>;

template <class T>
struct Range {
    T lower, upper;
};

/// Number or vector, each component within the range; in shaders, a member of the module's uniform block.
template <class T>
class Knob : public KnobBase {
  public:
    /// Throws Failure, which names the statement `where`, for a default outside the range, and for a range that differs
    /// by component.
    Knob(Module& owner, std::string name, T default_value, Range<T> range, std::string help, std::string unit = "",
         SourceLocation where = SourceLocation::current());
    void set(const std::string& text) override;
    std::string text() const override;
    void reset() override { value = default_value; }
    void change_default(const std::string& text) override { set(text), default_value = value; }
    nlohmann::json describe() const override;
    std::string usage() const override;
    bool changed() const override { return value != default_value; }
    Numbers numbers() const override;
    bool is_integer() const override { return std::is_same_v<T, int>; }
    operator T() const { return value; }
    T value;
    T default_value;
    const Range<T> range;
};

/// Boolean, compiled in as 1 or 0, so that a disabled feature costs nothing.
template <>
class Knob<bool> : public KnobBase {
  public:
    Knob(Module& owner, std::string name, bool default_value, std::string help,
         SourceLocation where = SourceLocation::current());
    void set(const std::string& text) override;
    std::string text() const override { return value ? "on" : "off"; }
    void reset() override { value = default_value; }
    void change_default(const std::string& text) override { set(text), default_value = value; }
    nlohmann::json describe() const override;
    std::string usage() const override { return default_value ? "{on,off} (on)" : "{on,off} (off)"; }
    bool changed() const override { return value != default_value; }
    void add_macros(Macros& macros) const override { macros.set(macro(), value ? "1" : "0"); }
    std::vector<std::string> variants() const override { return {"on", "off"}; }
    size_t variant() const override { return value; }
    operator bool() const { return value; }
    bool value;
    bool default_value;
};

/// Enumeration. Shaders compare the macro NAME with NAME_ONE, NAME_TWO, …
class Choice : public KnobBase {
  public:
    /// Throws Failure, which names the statement `where`, for a default that is not among the options.
    Choice(Module& owner, std::string name, std::vector<std::string> options, std::string default_option,
           std::string help, SourceLocation where = SourceLocation::current());
    void set(const std::string& text) override;
    std::string text() const override { return options[index]; }
    void reset() override { index = default_index_; }
    nlohmann::json describe() const override;
    std::string usage() const override;
    bool changed() const override { return index != default_index_; }
    void add_macros(Macros& macros) const override;
    std::vector<std::string> variants() const override { return options; }
    size_t variant() const override { return index; }
    bool is(std::string_view option) const { return options[index] == option; }
    void change_default(const std::string& option) override { set(option), default_index_ = index; }
    const std::vector<std::string> options;
    size_t index = 0;

  private:
    size_t default_index_ = 0;
};

/// Knob by path, or by short name if unambiguous. Throws InputError, listing candidate paths.
KnobBase& find_knob(const KnobList& knobs, const std::string& name);

/// Throws Failure if two knobs define one macro, as `b_c` of a module `a` and `c` of a module `a_b` do.
void check_macros(const KnobList& knobs);

/// True if find_knob() accepts the knob's name without its module.
bool has_short_name(const KnobList& knobs, const KnobBase& knob);

}  // namespace lightwalk
