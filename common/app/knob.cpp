#include "common/app/knob.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "common/app/module.h"
#include "common/base/error.h"
#include "common/base/names.h"

namespace lightwalk {
namespace {

std::string upper(std::string text) {
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

std::string format(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value)).ptr;
    return {buffer, end};
}

// 16777216 instead of 1.6777216e+07.
std::string short_number(double value) {
    return value == std::floor(value) && std::abs(value) < 1e9 ? fmt::format("{:.0f}", value) : format(value);
}

template <class T>
struct Components {
    static constexpr int count = 1;
    static double get(const T& value, int) { return static_cast<double>(value); }
    static void put(T& value, int, double number) { value = static_cast<T>(number); }
};
template <int N>
struct Components<glm::vec<N, float>> {
    static constexpr int count = N;
    static double get(const glm::vec<N, float>& value, int i) { return static_cast<double>(value[i]); }
    static void put(glm::vec<N, float>& value, int i, double number) { value[i] = static_cast<float>(number); }
};

template <class T>
constexpr const char* kind = std::is_same_v<T, int>      ? "integer"
                             : Components<T>::count == 1 ? "number"
                                                         : "numbers a,b,c";

}  // namespace

KnobBase::KnobBase(Module& knob_owner, std::string knob_name, std::string knob_help, std::string knob_unit,
                   SourceLocation where)
    : owner(knob_owner), name(std::move(knob_name)), help(std::move(knob_help)), unit(std::move(knob_unit)) {
    if (!is_macro_word(name)) throw Failure("{}: knob '{}': {}", place_of(where), path(), a_macro_word);
    if (help.empty())
        throw Failure("{}: knob '{}' has no help; say in a noun phrase what it sets", place_of(where), path());
    for (const Module::Member& other : owner.members_)
        if (other.knob && other.knob->name == name)
            throw Failure("{}: knob '{}' stands twice in one module; give one another name", place_of(where), path());
    owner.members_.push_back({.knob = this});
    owner.forget_macros();
}

KnobBase::~KnobBase() {
    std::erase_if(owner.members_, [this](const Module::Member& member) { return member.knob == this; });
    owner.forget_macros();
}

std::string KnobBase::path() const { return owner.path().empty() ? name : owner.path() + "." + name; }

std::string KnobBase::macro() const { return upper(owner.kind().empty() ? name : owner.kind() + "_" + name); }

template <class T>
Knob<T>::Knob(Module& knob_owner, std::string knob_name, T initial, Range<T> knob_range, std::string knob_help,
              std::string knob_unit, SourceLocation where)
    : KnobBase(knob_owner, std::move(knob_name), std::move(knob_help), std::move(knob_unit), where),
      value(initial),
      default_value(initial),
      range(knob_range) {
    using C = Components<T>;
    for (int i = 1; i < C::count; ++i)
        if (C::get(range.lower, i) != C::get(range.lower, 0) || C::get(range.upper, i) != C::get(range.upper, 0))
            throw Failure("{}: the range of {} differs by component, and one holds for all", place_of(where), path());
    try {
        set(text());
    } catch (const InputError& e) { throw Failure("{}: default of {}", place_of(where), e.what()); }
}

template <class T>
void Knob<T>::set(const std::string& given) {
    using C = Components<T>;
    const double lower = C::get(range.lower, 0), upper_bound = C::get(range.upper, 0);
    const auto refuse = [&] {
        const char* const article = C::count > 1 ? "" : std::is_same_v<T, int> ? "an " : "a ";
        throw InputError("{}={}: expected {}{} from {} to {}{}", path(), given, article, kind<T>, format(lower),
                         format(upper_bound), unit.empty() ? "" : " " + unit);
    };
    T parsed{};
    const char* at = given.data();
    const char* const end = at + given.size();
    for (int i = 0; i < C::count; ++i) {
        double number = 0;
        const auto [next, error] = std::from_chars(at, end, number);
        if (!std::is_same_v<T, int>)
            number = static_cast<double>(static_cast<float>(number));  // as the range is stored
        if (error != std::errc() || !std::isfinite(number) || number < lower || number > upper_bound) refuse();
        if (std::is_same_v<T, int> && number != std::floor(number)) refuse();
        C::put(parsed, i, number);
        at = next;
        if (i + 1 < C::count && (at == end || *at++ != ',')) refuse();
    }
    if (at != end) refuse();
    value = parsed;
}

template <class T>
std::string Knob<T>::text() const {
    std::string result;
    for (int i = 0; i < Components<T>::count; ++i) result += (i ? "," : "") + format(Components<T>::get(value, i));
    return result;
}

template <class T>
KnobBase::Numbers Knob<T>::numbers() const {
    Numbers result;
    for (int i = 0; i < Components<T>::count; ++i)
        result.values[result.count++] = static_cast<float>(Components<T>::get(value, i));
    return result;
}

template <class T>
nlohmann::json Knob<T>::describe() const {
    using C = Components<T>;
    const auto number = [](double component) {
        return std::is_same_v<T, int> ? nlohmann::json(static_cast<int>(component)) : nlohmann::json(component);
    };
    nlohmann::json defaults = nlohmann::json::array();
    for (int i = 0; i < C::count; ++i) defaults.push_back(number(C::get(default_value, i)));
    return {{"name", path()},
            {"type", kind<T>},
            {"default", C::count == 1 ? defaults[0] : defaults},
            {"range", {number(C::get(range.lower, 0)), number(C::get(range.upper, 0))}},
            {"unit", unit},
            {"help", help}};
}

template <class T>
std::string Knob<T>::usage() const {
    using C = Components<T>;
    std::string initial;
    for (int i = 0; i < C::count; ++i) initial += (i ? "," : "") + short_number(C::get(default_value, i));
    return fmt::format("{}..{}{} ({})", short_number(C::get(range.lower, 0)), short_number(C::get(range.upper, 0)),
                       unit.empty() ? "" : " " + unit, initial);
}

template class Knob<float>;
template class Knob<int>;
template class Knob<glm::vec3>;

Knob<bool>::Knob(Module& knob_owner, std::string knob_name, bool initial, std::string knob_help, SourceLocation where)
    : KnobBase(knob_owner, std::move(knob_name), std::move(knob_help), "", where),
      value(initial),
      default_value(initial) {}

void Knob<bool>::set(const std::string& given) {
    if (given != "on" && given != "off" && given != "true" && given != "false")
        throw InputError("{}={}: expected on or off", path(), given);
    value = given == "on" || given == "true";
}

nlohmann::json Knob<bool>::describe() const {
    return {{"name", path()}, {"type", "switch"}, {"default", default_value ? "on" : "off"}, {"help", help}};
}

Choice::Choice(Module& knob_owner, std::string knob_name, std::vector<std::string> names, std::string initial,
               std::string knob_help, SourceLocation where)
    : KnobBase(knob_owner, std::move(knob_name), std::move(knob_help), "", where), options(std::move(names)) {
    for (const std::string& option : options) {
        if (!is_macro_word("x" + option))
            throw Failure("{}: option '{}' of {}: {}", place_of(where), option, path(), a_macro_word);
        if (std::ranges::count(options, option) > 1)
            throw Failure("{}: option '{}' of {} stands twice", place_of(where), option, path());
    }
    try {
        set(initial);
    } catch (const InputError& e) { throw Failure("{}: default of {}", place_of(where), e.what()); }
    default_index_ = index;
}

void Choice::set(const std::string& given) {
    const auto it = std::find(options.begin(), options.end(), given);
    std::string known;
    for (const std::string& option : options) known += (known.empty() ? "" : ", ") + option;
    if (it == options.end()) throw InputError("{}={}: expected one of {}", path(), given, known);
    index = static_cast<size_t>(it - options.begin());
}

nlohmann::json Choice::describe() const {
    return {{"name", path()},
            {"type", "choice"},
            {"default", options[default_index_]},
            {"options", options},
            {"help", help}};
}

std::string Choice::usage() const {
    return fmt::format("{{{}}} ({})", fmt::join(options, ","), options[default_index_]);
}

void Choice::add_macros(Macros& macros) const {
    const std::string prefix = macro();
    macros.set(prefix, std::to_string(index));
    for (size_t i = 0; i < options.size(); ++i) macros.set(prefix + "_" + upper(options[i]), std::to_string(i));
}

namespace {

KnobList called(const KnobList& knobs, const std::string& name) {
    KnobList same;
    for (KnobBase* knob : knobs) {
        if (knob->name != name) continue;
        if (knob->preferred || knob->path() == name) return {knob};
        same.push_back(knob);
    }
    return same;
}

std::string either(const KnobList& knobs) {
    std::string text;
    for (const KnobBase* knob : knobs) text += (text.empty() ? "" : " or ") + knob->path();
    return text;
}

}  // namespace

KnobBase& find_knob(const KnobList& knobs, const std::string& name) {
    for (KnobBase* knob : knobs)
        if (knob->path() == name) return *knob;
    const KnobList same = called(knobs, name);
    if (same.size() == 1) return *same[0];
    if (!same.empty()) throw InputError("knob '{}' could be {}", name, either(same));
    std::vector<std::string> known;
    for (const KnobBase* knob : knobs) known.push_back(knob->path());
    throw unknown_name("knob", name, known, "--list knobs lists all");
}

void check_macros(const KnobList& knobs) {
    std::map<std::string, const KnobBase*> known;
    for (const KnobBase* knob : knobs) {
        Macros macros;
        knob->add_macros(macros);
        for (const auto& [name, value] : macros) {
            const KnobBase& other = *known.emplace(name, knob).first->second;
            // Modules of one kind share their shaders; a pass has one of them.
            if (other.owner.kind() != knob->owner.kind() || other.name != knob->name)
                throw Failure("{} and {} both define the macro {}; give one another name", other.path(), knob->path(),
                              name);
        }
    }
}

bool has_short_name(const KnobList& knobs, const KnobBase& knob) {
    return knob.path() != knob.name && called(knobs, knob.name) == KnobList{const_cast<KnobBase*>(&knob)};
}

}  // namespace lightwalk
