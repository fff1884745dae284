// Knobs: named parameters of a module. One declaration gives the option, the slider, the scene-file key, the shader's
// uniform or macro and the study's axis.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "common/gpu/macros.h"

namespace lightwalk {

class Module;

class KnobBase {
  public:
    /// Registers with the module that owns it.
    KnobBase(Module& owner, std::string name, std::string help, std::string unit);
    virtual ~KnobBase();
    KnobBase(const KnobBase&) = delete;

    /// Takes the text of --set, a scene file or a study. Throws InputError, which says the range or the names.
    virtual void set(const std::string& text) = 0;
    virtual std::string text() const = 0;  ///< the value as set() accepts it
    virtual void reset() = 0;
    virtual void change_default(const std::string& text) = 0;  ///< and its value with it
    virtual nlohmann::json describe() const = 0;

    /// Accepted values and the default, for --help: "{none,hard,pcf} (pcf)", "0..1 m (0.01)".
    virtual std::string usage() const = 0;

    /// Whether its value is another than the default.
    virtual bool changed() const = 0;

    /// Adds the macros of compiled-in knobs: SHADOW_FILTER, SHADOW_FILTER_PCF … for the knob `filter` of a module of
    /// kind `shadow`.
    virtual void add_macros(Macros&) const {}

    /// Every setting that gives another compiled variant; empty for uniforms.
    virtual std::vector<std::string> variants() const { return {}; }

    /// Another number for each of variants(), while it is set.
    virtual size_t variant() const { return 0; }

    /// Up to four numbers for a uniform, as float or int bits; empty for macros.
    struct Numbers {
        std::array<float, 4> values{};
        size_t count = 0;
        const float* begin() const { return values.data(); }
        const float* end() const { return values.data() + count; }
    };
    virtual Numbers numbers() const { return {}; }

    std::string path() const;   ///< with its module's before it: shadow.filter
    std::string macro() const;  ///< the first of its macros' names: SHADOW_FILTER

    Module& owner;
    const std::string name, help, unit;
    bool pinned = false;  ///< on the command line: a scene file does not overrule it
    bool alone = false;   ///< answers to its name alone, also where another module has one of that name
};

using KnobList = std::vector<KnobBase*>;

template <class T>
struct Range {
    T lower, upper;
};

/// A number, or a vector of numbers (all in one range), as a member of the same name in its module's uniform block.
template <class T>
class Knob : public KnobBase {
  public:
    Knob(Module& owner, std::string name, T default_value, Range<T> range, std::string help, std::string unit = "");
    void set(const std::string& text) override;
    std::string text() const override;
    void reset() override { value = default_value; }
    void change_default(const std::string& text) override { set(text), default_value = value; }
    nlohmann::json describe() const override;
    std::string usage() const override;
    bool changed() const override { return value != default_value; }
    Numbers numbers() const override;
    operator T() const { return value; }
    T value;
    T default_value;
    const Range<T> range;
};

/// On or off, compiled in as 1 or 0: a feature that is off costs nothing.
template <>
class Knob<bool> : public KnobBase {
  public:
    Knob(Module& owner, std::string name, bool default_value, std::string help);
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

/// One of several names: a shader compares NAME with NAME_ONE, NAME_TWO ...
class Choice : public KnobBase {
  public:
    Choice(Module& owner, std::string name, std::vector<std::string> options, std::string default_option,
           std::string help);
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

/// By path, or by name alone where no other module has it too, or it is the one that answers to it. Throws InputError
/// and lists the paths where there is no such knob, or more than one.
KnobBase& find_knob(const KnobList& knobs, const std::string& name);

/// Whether find_knob() takes the knob's name without its module's.
bool has_short_name(const KnobList& knobs, const KnobBase& knob);

}  // namespace lightwalk
