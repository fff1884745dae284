#include "18_playground/properties.h"

#include <fmt/core.h>

#include <algorithm>

#include "18_playground/saving.h"
#include "18_playground/tree.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

using Kind = Light::Kind;

bool is_light(const Entry& entry) { return entry.light(); }
bool is_spot(const Entry& entry) { return entry.light() && entry.light()->kind == Kind::spot; }
bool has_direction(const Entry& entry) { return entry.light() && entry.light()->kind != Kind::point; }
bool has_place(const Entry& entry) { return entry.light() && entry.light()->kind != Kind::directional; }
bool is_object(const Entry& entry) { return entry.object(); }
bool has_model(const Entry& entry) { return entry.object() && !entry.object()->model.empty(); }

template <class Value>
Property of_light(const char* name, bool (*has)(const Entry&), Value Light::*field, const PropertyField& shown) {
    return {name,
            has,
            [=](EntryId, const Entry& entry) { return glm::vec3(entry.light()->*field); },
            [=](Entry& entry, const glm::vec3& value) {
                if constexpr (std::is_same_v<Value, glm::vec3>)
                    entry.light()->*field = value;
                else
                    entry.light()->*field = static_cast<Value>(value.x);
            },
            [=](Entry& entry) { entry.light()->*field = Light().*field; },
            shown};
}

Property angle_of_light(const char* name, bool (*has)(const Entry&), float Light::*field, const PropertyField& shown) {
    return {name,
            has,
            [=](EntryId, const Entry& entry) { return glm::vec3(glm::degrees(entry.light()->*field)); },
            [=](Entry& entry, const glm::vec3& value) {
                Light& light = *entry.light();
                light.*field = glm::radians(value.x);
                light.inner_rad = std::min(light.inner_rad, light.outer_rad);
            },
            [=](Entry& entry) {
                Light& light = *entry.light();
                light.*field = Light().*field;
                light.inner_rad = std::min(light.inner_rad, light.outer_rad);
            },
            shown};
}

Property of_object(glm::vec3 SceneObject::*field, const PropertyField& shown) {
    return {shown.label,
            is_object,
            [=](EntryId, const Entry& entry) { return entry.object()->*field; },
            [=](Entry& entry, const glm::vec3& value) { entry.object()->*field = value; },
            [=](Entry& entry) { entry.object()->*field = SceneObject().*field; },
            shown};
}

template <class Value>
Property of_material(std::optional<Value> MaterialOverride::*field, Value otherwise, const PropertyField& shown,
                     const std::function<const MaterialNumbers*(EntryId)>& own = {},
                     Value MaterialNumbers::*own_field = nullptr) {
    return {shown.label,
            has_model,
            [=](EntryId id, const Entry& entry) {
                if (const auto& given = entry.object()->material.*field) return glm::vec3(*given);
                const MaterialNumbers* material = own ? own(id) : nullptr;
                return glm::vec3(material ? material->*own_field : otherwise);
            },
            [=](Entry& entry, const glm::vec3& value) {
                if constexpr (std::is_same_v<Value, glm::vec3>)
                    entry.object()->material.*field = value;
                else
                    entry.object()->material.*field = value.x;
            },
            [=](Entry& entry) { (entry.object()->material.*field).reset(); },
            shown};
}

const Property& named(const std::vector<Property>& all, const std::string& name) {
    for (const Property& one : all)
        if (one.name == name) return one;
    throw Failure("there is no property '{}'", name);
}

}  // namespace

const std::vector<Property>& light_properties() {
    static const std::vector<Property> all = [] {
        Property direction =
            of_light("direction", has_direction, &Light::direction,
                     {PropertyField::numbers, "direction", "Direction in which the light travels", 0.01f});
        direction.set = [](Entry& entry, const glm::vec3& value) {
            if (glm::length(value) > 1e-6f) entry.light()->direction = glm::normalize(value);
        };
        const Property type{
            .name = "type",
            .has = is_light,
            .get = [](EntryId, const Entry& entry) { return glm::vec3(float(entry.light()->kind)); },
            .set = [](Entry& entry, const glm::vec3& value) { entry.light()->kind = static_cast<Kind>(value.x); },
            .field = {PropertyField::choice, "type", ""}};
        constexpr auto number = PropertyField::number;
        return std::vector<Property>{
            type,
            of_light("colour", is_light, &Light::color,
                     {PropertyField::color, "color", "Colour of the light, linear", 0, 0, 1}),
            of_light("intensity", is_light, &Light::intensity,
                     {number, "intensity", "Intensity: the factor of the colour", -0.02f, 0, 1e6f}),
            direction,
            angle_of_light(
                "angular size", is_sun, &Light::size_rad,
                {number, "lamp size", "Angle that the lamp subtends, in degrees (the sun: 0.53); it softens shadows",
                 0.01f, 0, 90}),
            of_light("position", has_place, &Light::position,
                     {PropertyField::numbers, "position", "Position in the world, in metres", 0.01f}),
            of_light("range", has_place, &Light::range_m,
                     {number, "range", "Distance at which the light ends, in metres", 0.05f, 0, 1e6f}),
            of_light("lamp size", has_place, &Light::size_m,
                     {number, "lamp size", "Diameter of the lamp, in metres; it softens shadows", 0.005f, 0, 1e3f}),
            angle_of_light(
                "inner angle", is_spot, &Light::inner_rad,
                {number, "inner angle", "Half angle of the cone with the full intensity, in degrees", 0.2f, 0, 180}),
            angle_of_light("outer angle", is_spot, &Light::outer_rad,
                           {number, "outer angle", "Half angle of the whole cone, in degrees", 0.2f, 0, 180}),
            of_light("softness", is_spot, &Light::softness,
                     {number, "softness", "Softness of the cone's edge", 0.01f, 0, 1}),
            of_light("shadow", is_light, &Light::shadow,
                     {PropertyField::check, "shadow", "Whether the light casts shadows"})};
    }();
    return all;
}

const Property& light_property(const std::string& name) { return named(light_properties(), name); }

const Property& object_property(const std::string& name) {
    static const std::vector<Property> all{
        of_object(&SceneObject::position,
                  {PropertyField::numbers, "position", "Position in the parent's space, in metres"}),
        of_object(&SceneObject::rotation_deg,
                  {PropertyField::numbers, "rotation", "Rotation about x, then y, then z, in degrees", 0.5f}),
        of_object(&SceneObject::scale,
                  {PropertyField::numbers, "scale", "Scale along the object's own axes; negative: mirrored", 0.01f})};
    return named(all, name);
}

std::vector<Property> material_properties(const std::function<const MaterialNumbers*(EntryId)>& own) {
    using Override = MaterialOverride;
    const MaterialNumbers plain;
    constexpr auto number = PropertyField::number, color = PropertyField::color;
    Property transmission =
        of_material(&Override::transmission, glm::vec3(1),
                    {color, "transmission", "Share of the light that opacity lets through, by channel", 0, 0, 1}, own,
                    &Material::transmission);
    transmission.get = [get = transmission.get](EntryId id, const Entry& entry) {
        const glm::vec3 value = get(id, entry);
        return value.x < 0 ? glm::vec3(1) : value;  // unspecified: white
    };
    return {
        of_material(&Override::diffuse, plain.diffuse,
                    {color, "diffuse", "Diffuse colour: the share of light that is scattered, linear", 0, 0, 1}, own,
                    &Material::diffuse),
        of_material(&Override::specular, plain.specular,
                    {color, "specular", "Specular colour: the share that is reflected, linear", 0, 0, 1}, own,
                    &Material::specular),
        of_material(&Override::emissive, plain.emissive,
                    {color, "emissive", "Emitted radiance, in the unit of the scene's light", 0, 0, 1e4f}, own,
                    &Material::emissive),
        of_material(&Override::shininess, plain.shininess,
                    {number, "shininess", "Exponent of the highlight; a larger one is sharper", 1, 0, 1e5f}, own,
                    &Material::shininess),
        of_material(&Override::roughness, plain.roughness,
                    {number, "roughness", "Roughness: 0 is a mirror, 1 is dull", 0.01f, 0, 1}),
        of_material(&Override::metalness, plain.metalness,
                    {number, "metalness", "Metalness: 0 is an insulator, 1 is a metal", 0.01f, 0, 1}),
        of_material(&Override::opacity, plain.opacity,
                    {number, "opacity", "Opacity: 0 is invisible, 1 is opaque", 0.01f, 0, 1}, own, &Material::opacity),
        transmission};
}

Property material_property(const std::string& name, const std::function<const MaterialNumbers*(EntryId)>& own) {
    return named(material_properties(own), name);
}

std::string short_number(float value, const std::function<bool(const std::string&)>& fits) {
    std::string text;
    for (int digits = 5; digits > 0 && (text.empty() || !fits(text)); --digits)
        text = fmt::format("{:.{}g}", value, digits);
    return text;
}

std::string exact_format(float value) {
    int digits = 6;
    while (digits < 9 && std::strtof(fmt::format("{:.{}g}", value, digits).c_str(), nullptr) != value) ++digits;
    return fmt::format("%.{}g", digits);
}

std::vector<EntryId> edited_together(const Document& document, const Selection& selection) {
    const Entry* const active = document.find(selection.active());
    std::vector<EntryId> ids;
    if (!active) return ids;
    for (const EntryId id : selection.ids)
        if (const Entry* entry = document.find(id); entry && entry->what.index() == active->what.index())
            ids.push_back(id);
    return ids;
}

SharedValue shared_value(const Document& document, const std::vector<EntryId>& ids, const Property& property) {
    SharedValue shared;
    for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
        const Entry& entry = document.at(*id);
        if (!property.has(entry)) continue;
        const glm::vec3 value = property.get(*id, entry);
        if (shared.ids.empty()) shared.value = value;
        for (int i = 0; i < 3; ++i) shared.mixed[i] |= value[i] != shared.value[i];
        shared.ids.push_back(*id);
    }
    std::reverse(shared.ids.begin(), shared.ids.end());
    return shared;
}

// [set_property]
Said set_property(Document& document, const std::vector<EntryId>& ids, const Property& property, const glm::vec3& value,
                  glm::bvec3 which, uint64_t gesture, const std::filesystem::path& file) {
    const auto wanted = [&](EntryId id) { return glm::mix(property.get(id, document.at(id)), value, which); };
    std::vector<EntryId> others;
    for (const EntryId id : ids)
        if (const Entry* entry = document.find(id);
            entry && property.has(*entry) && property.get(id, *entry) != wanted(id))
            others.push_back(id);
    return edit_all(document, others, property.name, gesture, file,
                    [&](EntryId id, Entry& entry) { property.set(entry, wanted(id)); });
}
// [/set_property]

std::vector<EntryId> resettable(const Document& document, const std::vector<EntryId>& ids, const Property& property) {
    std::vector<EntryId> found;
    for (const EntryId id : ids) {
        const Entry& entry = document.at(id);
        if (!property.reset || !property.has(entry)) continue;
        Entry plain = entry;
        property.reset(plain);
        if (property.get(id, plain) != property.get(id, entry)) found.push_back(id);
    }
    return found;
}

Said reset_property(Document& document, const std::vector<EntryId>& ids, const Property& property,
                    const std::filesystem::path& file) {
    return edit_all(document, resettable(document, ids, property), "reset " + property.name, 0, file,
                    [&](EntryId, Entry& entry) { property.reset(entry); });
}

Said edit_all(Document& document, const std::vector<EntryId>& ids, const std::string& what, uint64_t gesture,
              const std::filesystem::path& file, const std::function<void(EntryId, Entry&)>& edit) {
    std::vector<EntryId> open;
    for (const EntryId id : ids)
        if (!is_locked(document, id)) open.push_back(id);
    const size_t locked = ids.size() - open.size();
    const Said stays = ids.size() == 1 ? "it is locked" : fmt::format("{} of {} are locked", locked, ids.size());
    if (open.empty()) return locked ? stays : "";
    document.begin(open.size() == 1 ? what + " of " + shown_name(document.at(open[0]))
                                    : fmt::format("{} of {} entries", what, open.size()),
                   gesture);
    Said refused;
    for (size_t i = 0; i < open.size() && refused.empty(); ++i) {
        Entry& entry = document.edit(open[i]);
        edit(open[i], entry);
        if (const SceneObject* object = entry.object()) refused = cannot_be_placed(placement_of(*object));
        // All get the same, and all were right before: the file's own judgement, which takes a while, is asked for one.
        if (refused.empty() && i + 1 == open.size()) refused = cannot_be_saved(entry, file);
    }
    refused.empty() ? void(document.commit()) : document.cancel();
    return !refused.empty() ? refused : locked ? stays : "";
}

}  // namespace lightwalk
