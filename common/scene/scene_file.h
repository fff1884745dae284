// Scene files: JSON that places models, a camera and lights. Every error names file, line and key. An unknown key is an
// error.
//
//   include      list of scene files, relative to this one, read before it. Objects and lights of all are kept; of
//                other keys, the last value read.
//   camera       position [0, 0, 3] and target [0, 0, 0] in metres, up [0, 1, 0] (each -1 to 1), fov_deg 45.8 (1 to
//                170, the whole vertical angle), near_m 0.05 (1e-5 to 1e5), far_m 1000 (above near_m, to 1e9)
//   ambient      [0.05, 0.05, 0.05], linear radiance from everywhere, 0 to 1e4
//   background   [0.02, 0.02, 0.02], linear, 0 to 1e4
//   environment  a file name, or
//     image          .hdr or .pfm, all directions, twice as wide as high; below assets/ or a whole path; required
//     intensity      1, scale factor of its radiance, 0 to 1e6
//     rotation_deg   0, rotation about +y, counter-clockwise seen from above; -1e6 to 1e6
//   music        an Ogg Vorbis file; below assets/ or a whole path; its time 0 is the scene's
//   objects      list of
//     name, parent   texts; a parent is another object's name; none
//     role           special meaning in some chapters: planet, ring (of the planet), screen, skin, eye
//                    or cornea; none. Or {material: role} with skin, eye and cornea for those materials of its model.
//                    In a file without any role the objects named planet, ring and "screen NAME" (which shows "camera
//                    NAME") and the materials named skin, eye and cornea have these roles
//     shows          for a screen: the object from which it shows the view, along that object's -z; required
//     model          a model file, below assets/ or a whole path; none: a group, which places its children
//     position       [0, 0, 0], metres in the parent's space
//     rotation_deg   [0, 0, 0], about x, then y, then z
//     scale          1, or [1, 1, 1]; -1e6 to 1e6 but not 0; an odd number of negative ones mirrors
//     material       overrides the model's: diffuse and specular [r, g, b] (linear, 0 to 1), emissive
//                    (0 to 1e4), shininess (0 to 1e5), opacity (0 to 1; below 1 it is transparent), blend (true: alpha
//                    and the opacity map blend with the background; false: they cut holes; transparent objects are
//                    drawn last, the farthest first, and cast no shadow), two_sided (true: the back is drawn, too,
//                    unless the model decides), roughness, metalness (0 to 1), maps {slot: file} (diffuse, specular,
//                    emissive, opacity, normal, height, orm, occlusion, gloss, detail_normal, displacement,
//                    metallic_roughness)
//     ground         false; true: not the model is drawn, but a ground below it, with the soft shadow of a sky above
//     hidden         false; true: neither it nor its children are drawn
//     locked         false; true: the editor (chapter 18) changes neither it nor its children
//     motion         at least one of
//       spin_deg_per_s   0, about axis ([0, 1, 0], any length above 0) in the object's own space, -1e5 to 1e5
//       path             list of keyframes: time_s (required, rising, -1e6 to 1e6), position, rotation_deg, scale (the
//                        object's own where not given; scales keep their signs). A smooth curve goes through them; an
//                        open path rests before the first and after the last.
//       period_s         closes the path: so long after the first keyframe the object is there again; above the time
//                        from the first to the last, to 1e6
//   lights       list of
//     type           directional (the default), point or spot
//     color          [1, 1, 1], linear, 0 to 1
//     intensity      1, at the surface (directional) or at 1 m; 0 to 1e6
//     direction      [0, -1, 0], the way the light travels, any length above 0; directional and spot
//     position       [0, 0, 0], metres; point and spot
//     range_m        10, 0 to 1e6: beyond it a falloff with an end is 0; point and spot
//     inner_deg, outer_deg, softness   17.2, 28.6 (half angles, 0 to 180, inner at most outer), 0.5 (0 to 1); spot
//     shadow         false; true: it casts shadows
//     size_m         0, diameter of the lamp, 0 to 1e3; point and spot
//     tube_m         [0, 0, 0], from one end of a lamp that is a tube of this diameter to the other, -1e3 to 1e3; point
//     size_deg       0, how wide the lamp looks (the sun: 0.53), 0 to 90; directional
//     name           a text; none
//     hidden         false; true: it is switched off
//     locked         false; true: the editor does not change it
//   emission     1, scale factor of all emitted light, 0 to 1e4
//   bare         false; true: made for a model alone. What its materials state of roughness is drawn even where they
//                state an exponent, too
//   knobs        {name: value}, knobs of the chapter that shows the scene
//   knobs_of     the chapter of these knobs, such as 18_playground: other chapters ignore knobs that they lack. Without
//                it every chapter refuses a knob that it lacks
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/scene/camera.h"
#include "common/scene/light.h"
#include "common/scene/motion.h"
#include "common/scene/role.h"

namespace lightwalk {

/// Overrides of a model's materials. Absent properties keep the model's values.
struct MaterialOverride {
    std::optional<glm::vec3> diffuse, specular, emissive;  ///< linear
    std::optional<float> shininess, opacity, roughness, metalness;
    std::optional<bool> blend;
    std::optional<bool> two_sided;                      ///< for materials that leave it open
    std::map<std::string, std::filesystem::path> maps;  ///< by slot, such as "normal" or "height"
    bool operator==(const MaterialOverride&) const = default;
};

struct SceneObject {
    std::string name, parent;      ///< parent: another object's name, or empty
    std::filesystem::path model;   ///< relative to assets/, or absolute; empty: a group
    glm::vec3 position{0.0f};      ///< metres
    glm::vec3 rotation_deg{0.0f};  ///< about x, then y, then z
    glm::vec3 scale{1.0f};
    MaterialOverride material;
    Motion motion{};
    GivenRole role{};
    bool ground = false;  ///< instead of the model: a ground below it, with its soft shadow (common/scene/bare.h)
    std::string shows{};  ///< for a screen: name of the object with the view it shows
    bool hidden = false;  ///< neither it nor its children are drawn
    bool locked = false;  ///< neither it nor its children are changed in an editor
};

/// A light that is switched off.
struct HiddenLight {
    size_t before = 0;  ///< how many of SceneFile::lights stand before it
    Light light;
};

/// Light from far away in every direction, as an image.
struct Environment {
    std::filesystem::path image;  ///< relative to assets/, or absolute; empty: none
    float intensity = 1;
    float rotation_deg = 0;  ///< about +y
    std::string where{};     ///< "file:line: key 'image'", for errors found when it is loaded
    explicit operator bool() const { return !image.empty(); }
};

/// A piece of music that begins at 0 s.
struct SceneMusic {
    std::filesystem::path file;  ///< relative to assets/, or absolute; empty: none
    std::string where{};         ///< "file:line: key 'music'", for errors found when it is loaded
    explicit operator bool() const { return !file.empty(); }
};

struct SceneFile {
    std::filesystem::path file;
    Camera camera;
    std::vector<SceneObject> objects;  ///< a parent stands before its children
    std::vector<Light> lights;
    std::vector<HiddenLight> hidden_lights;
    glm::vec3 ambient{0.05f};     ///< linear radiance from everywhere
    glm::vec3 background{0.02f};  ///< linear
    Environment environment;
    SceneMusic music;
    bool bare = false;   ///< made for a model alone
    float emission = 1;  ///< scale factor for emitted light
    std::map<std::string, std::string> knobs;
    std::string knobs_of{};  ///< the chapter that they were set in; empty: whichever shows the scene
};

/// Reads the file and those it includes. Throws InputError: syntax error, unknown key, wrong type, value out of range,
/// missing asset, a cycle of includes or parents.
SceneFile read_scene(const std::filesystem::path& path);
SceneFile parse_scene(const std::string& text, const std::filesystem::path& path);

/// Writes a scene for read_scene, whole or not at all.
void write_scene(const SceneFile& scene, const std::filesystem::path& path);

/// The text of write_scene. Equal scenes give equal texts; each number is the shortest decimal, of at most nine
/// digits, that reads back as the same float. `includes`: file names as written in the file; `scene` omits their
/// objects and lights.
std::string scene_text(const SceneFile& scene, const std::vector<std::string>& includes = {});

/// Writes the scene's camera and knobs into an existing scene file and preserves the rest: includes, key order, later
/// edits. Throws InputError if the file does not parse.
void update_scene(const SceneFile& scene, const std::filesystem::path& path);

/// An asset's path: as given if it exists, else below assets/ or the root. Throws InputError if it is in none.
std::filesystem::path find_asset(const std::filesystem::path& path);

/// The object's transform into its parent's space at a time: scale, then spin, then rotation, then position.
glm::mat4 local_transform(const SceneObject& object, float time_s = 0.0f);

}  // namespace lightwalk
