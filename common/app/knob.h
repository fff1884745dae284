// Knobs: a chapter's named parameters. One declaration gives the option, the slider, the scene-file key, the shader's
// uniform or macro and the study's axis.
#pragma once
#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace lightwalk {

class KnobBase {
  public:
    /// Registers with the chapter under construction.
    KnobBase(std::string name, std::string help, std::string unit);
    virtual ~KnobBase();
    KnobBase(const KnobBase&) = delete;

    /// Takes the text of --set, a scene file or a study. Throws InputError, which says the range or the names.
    virtual void set(const std::string& text) = 0;
    virtual std::string text() const = 0;  ///< what set() would take back
    virtual void reset() = 0;
    virtual nlohmann::json describe() const = 0;

    /// A macro's name and value for shaders, for knobs that are compiled in; empty for uniforms.
    virtual std::vector<std::pair<std::string, std::string>> macros() const { return {}; }

    /// Every setting that gives another compiled variant; empty for uniforms.
    virtual std::vector<std::string> variants() const { return {}; }

    /// Up to four numbers for a uniform, as float or int bits; empty for macros.
    virtual std::vector<float> numbers() const { return {}; }

    const std::string name, help, unit;
    bool pinned = false;  ///< on the command line: a scene file does not overrule it
};

/// The knobs of the chapter that is being made, in order of declaration.
using KnobList = std::vector<KnobBase*>;
KnobList*& knobs_under_construction();

template <class T>
struct Range {
    T lower, upper;
};

/// A number, or a vector of numbers (all in one range), as a uniform of the same name.
template <class T>
class Knob : public KnobBase {
  public:
    Knob(std::string name, T default_value, Range<T> range, std::string help, std::string unit = "");
    void set(const std::string& text) override;
    std::string text() const override;
    void reset() override { value = default_value; }
    nlohmann::json describe() const override;
    std::vector<float> numbers() const override;
    operator T() const { return value; }
    T value;
    const T default_value;
    const Range<T> range;
};

/// On or off: compiled in as NAME 1 or NAME 0, so that what is off costs nothing.
template <>
class Knob<bool> : public KnobBase {
  public:
    Knob(std::string name, bool default_value, std::string help);
    void set(const std::string& text) override;
    std::string text() const override { return value ? "on" : "off"; }
    void reset() override { value = default_value; }
    nlohmann::json describe() const override;
    std::vector<std::pair<std::string, std::string>> macros() const override;
    std::vector<std::string> variants() const override { return {"on", "off"}; }
    operator bool() const { return value; }
    bool value;
    const bool default_value;
};

/// One of several names: a shader compares NAME with NAME_ONE, NAME_TWO ...
class Choice : public KnobBase {
  public:
    Choice(std::string name, std::vector<std::string> options, std::string default_option, std::string help);
    void set(const std::string& text) override;
    std::string text() const override { return options[index]; }
    void reset() override { index = default_index_; }
    nlohmann::json describe() const override;
    std::vector<std::pair<std::string, std::string>> macros() const override;
    std::vector<std::string> variants() const override { return options; }
    bool is(std::string_view option) const { return options[index] == option; }
    const std::vector<std::string> options;
    size_t index = 0;

  private:
    size_t default_index_ = 0;
};

/// Throws InputError and lists the names where there is no such knob.
KnobBase& find_knob(const KnobList& knobs, const std::string& name);

}  // namespace lightwalk
