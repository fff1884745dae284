// Properties of the selection: common values, and edits of all entries in one step.
#pragma once
#include "18_playground/commands.h"

namespace lightwalk {

/// A property's row in the panel.
struct PropertyField {
    enum Kind { number, numbers, color, check, choice } kind = number;
    const char *label, *help;
    float speed = 0;  ///< of a drag, a pixel; below 0: times the value
    float lower = 0, upper = 0;
};

/// One number of an entry or three, in the units that a person reads: degrees, and 0 or 1 for a switch.
struct Property {
    std::string name;                       ///< as a step says it: "colour"
    std::function<bool(const Entry&)> has;  ///< a point light has no cone
    std::function<glm::vec3(EntryId, const Entry&)> get;
    std::function<void(Entry&, const glm::vec3&)> set;
    std::function<void(Entry&)> reset = {};  ///< to what holds where the file says nothing; none: nothing does
    PropertyField field = {};
};

/// A common value of several entries.
struct SharedValue {
    std::vector<EntryId> ids;  ///< entries with the property
    glm::vec3 value{0.0f};     ///< of the last of them, which is the active entry
    glm::bvec3 mixed{false};   ///< which numbers are not the same in all
};

/// type (as Light::Kind), colour, intensity, direction, angular size, position, range, lamp size, inner angle, outer
/// angle, softness or shadow: the panel's rows in order.
const std::vector<Property>& light_properties();
const Property& light_property(const std::string& name);

/// position, rotation or scale.
const Property& object_property(const std::string& name);

/// diffuse, specular, emissive, shininess, roughness, metalness, opacity and transmission of an object with a model.
/// `own`: the model's own material, which holds where the object overrides nothing; null: not known.
std::vector<Property> material_properties(const std::function<const MaterialNumbers*(EntryId)>& own);
Property material_property(const std::string& name, const std::function<const MaterialNumbers*(EntryId)>& own);

/// A number where there is little room: at most five digits, as many as fit; one where none do.
std::string short_number(float value, const std::function<bool(const std::string&)>& fits);

/// A format of printf() with the fewest digits, six or more, that are read back as the same float.
std::string exact_format(float value);

/// Entries edited together: the selected ones of the active entry's kind, objects or lights; the active one is the
/// last.
std::vector<EntryId> edited_together(const Document& document, const Selection& selection);

SharedValue shared_value(const Document& document, const std::vector<EntryId>& ids, const Property& property);

/// Sets the numbers that `which` names, of all entries with the property: "colour of 12 entries". Each keeps its
/// other numbers; locked entries stay, with a message. Changes nothing if the scene file at `file` would refuse one
/// of them.
Said set_property(Document& document, const std::vector<EntryId>& ids, const Property& property, const glm::vec3& value,
                  glm::bvec3 which = glm::bvec3(true), uint64_t gesture = 0, const std::filesystem::path& file = {});

/// Those that reset_property() would change.
std::vector<EntryId> resettable(const Document& document, const std::vector<EntryId>& ids, const Property& property);
Said reset_property(Document& document, const std::vector<EntryId>& ids, const Property& property,
                    const std::filesystem::path& file);

/// The same for any edit that sets the same in all.
Said edit_all(Document& document, const std::vector<EntryId>& ids, const std::string& what, uint64_t gesture,
              const std::filesystem::path& file, const std::function<void(EntryId, Entry&)>& edit);

}  // namespace lightwalk
