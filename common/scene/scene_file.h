// Scene files: JSON with models, a camera and lights. Keys with default and range; unknown keys are errors.
//
//   include      list of scene files, relative to this one, read first; objects and lights accumulate
//   camera       position [0, 0, 3] and target [0, 0, 0] in metres, up [0, 1, 0] (each -1 to 1), fov_deg 45.8 (1 to
//                170, vertical), near_m 0.05 (1e-5 to 1e5), far_m 1000 (above near_m, to 1e9)
//   ambient, background   [0.05, 0.05, 0.05] and [0.02, 0.02, 0.02], linear radiance, 0 to 1e4
//   environment  a file name, or
//     image          .hdr or .pfm, equirectangular (2:1); below assets/ or an absolute path; required
//     intensity      1, factor on radiance, 0 to 1e6
//     rotation_deg   0, about +y, counter-clockwise seen from above; -1e6 to 1e6
//   music        Ogg Vorbis file, starting at the scene's time 0; below assets/ or an absolute path
//   objects      list of
//     name, parent   texts; parent: name of another object; none
//     role           meaning for some chapters: planet, ring, screen, skin, eye or cornea; none. Or {material: role},
//                    with skin, eye or cornea. In files without any role, names decide: objects planet, ring and
//                    "screen NAME" (showing "camera NAME"), materials skin, eye and cornea
//     shows          object whose view along -z a screen shows; required for screens
//     model          model file, below assets/ or an absolute path; none: a group with children
//     position       [0, 0, 0], metres in the parent's space
//     rotation_deg   [0, 0, 0], about x, then y, then z
//     scale          1, or [1, 1, 1]; -1e6 to 1e6 but not 0; an odd number of negative values mirrors
//     material       overrides the model's: diffuse and specular [r, g, b] (linear, 0 to 1), emissive (0 to 1e4),
//                    shininess (0 to 1e5), opacity (0 to 1; below 1: transparent), transmission [r, g, b] (0 to 1: of
//                    the light that opacity lets through, the share that passes), blend (true: alpha and opacity map
//                    blend with the background; false: they cut holes; transparent objects are drawn last, farthest
//                    first, and cast no shadow), two_sided (true: no back-face culling, unless the model decides),
//                    roughness, metalness (0 to 1), maps {slot: file} (diffuse, specular, emissive, opacity, normal,
//                    height, orm, occlusion, gloss, detail_normal, displacement, metallic_roughness)
//     ground         false; true: instead of the model, a ground below it with the soft shadow of a sky
//     hidden, locked false; true: not drawn; not changed by the editor (chapter 18); with children
//     motion         at least one of
//       spin_deg_per_s   0, about axis ([0, 1, 0], any positive length) in object space, -1e5 to 1e5
//       path             list of keyframes: time_s (required, ascending, -1e6 to 1e6), position, rotation_deg, scale
//                        (default: the object's; scales keep their signs), joined by a smooth curve. An open path is
//                        constant before the first and after the last keyframe
//       period_s         closes the path: period, above the time from first to last keyframe, to 1e6
//   lights       list of
//     type           directional (default), point or spot
//     color          [1, 1, 1], linear, 0 to 1
//     intensity      1, at the surface (directional) or at 1 m; 0 to 1e6
//     direction      [0, -1, 0], of propagation, any positive length; directional and spot
//     position       [0, 0, 0], metres; point and spot
//     range_m        10, cut-off of ranged falloffs, 0 to 1e6; point and spot
//     inner_deg, outer_deg, softness   17.2, 28.6 (half angles, 0 to 180, inner at most outer), 0.5 (0 to 1); spot
//     shadow         false; true: casts shadows
//     size_m         0, diameter of the light source, 0 to 1e3; point and spot
//     tube_m         [0, 0, 0], axis of a tube light of diameter size_m, end to end, -1e3 to 1e3; point
//     size_deg       0, angular diameter (the sun: 0.53), 0 to 90; directional
//     name, hidden, locked   text, none; false, true: switched off; false, true: not changed by the editor
//   emission     1, factor on all emitted light, 0 to 1e4
//   bare         false; true: for a single model; roughness is used even if a material also states an exponent
//   knobs        {name: value}, knobs of the chapter that shows the scene
//   knobs_of     chapter of these knobs, such as 18_playground: others ignore unknown knobs; without it, errors
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

/// Material overrides; absent values keep the model's.
struct MaterialOverride {
    std::optional<glm::vec3> diffuse, specular, emissive, transmission;
    std::optional<float> shininess, opacity, roughness, metalness;
    std::optional<bool> blend;
    std::optional<bool> two_sided;                      ///< default where the model states nothing
    std::map<std::string, std::filesystem::path> maps;  ///< keys: slots, for instance "normal"
    bool operator==(const MaterialOverride&) const = default;
};

struct SceneObject {
    std::string name, parent;     ///< parent: name of another object, or empty
    std::filesystem::path model;  ///< relative to assets/, or absolute; empty: a group
    glm::vec3 position{0.0f};     ///< metres
    glm::vec3 rotation_deg{0.0f};
    glm::vec3 scale{1.0f};
    MaterialOverride material;
    Motion motion{};
    GivenRole role{};
    bool ground = false;  ///< shows the ground below the model instead (common/scene/bare.h)
    std::string shows{};
    bool hidden = false;  ///< hides the children, too
    bool locked = false;  ///< locks the children, too
};

struct HiddenLight {
    size_t before = 0;  ///< number of SceneFile::lights before it
    Light light;
};

struct Environment {
    std::filesystem::path image;  ///< relative to assets/, or absolute; empty: none
    float intensity = 1;
    float rotation_deg = 0;  ///< about +y
    std::string where{};     ///< "file:line: key 'image'", for errors found while loading
    explicit operator bool() const { return !image.empty(); }
};

struct SceneMusic {
    std::filesystem::path file;
    std::string where{};
    explicit operator bool() const { return !file.empty(); }
};

struct SceneFile {
    std::filesystem::path file;
    Camera camera;
    std::vector<SceneObject> objects;  ///< parents precede children
    std::vector<Light> lights;
    std::vector<HiddenLight> hidden_lights;
    glm::vec3 ambient{0.05f};  ///< linear radiance from all directions
    glm::vec3 background{0.02f};
    Environment environment;
    SceneMusic music;
    bool bare = false;
    float emission = 1;
    std::map<std::string, std::string> knobs;
    std::string knobs_of{};  ///< chapter that the knobs belong to; empty: any
};

/// Reads a file with its includes. Throws InputError: syntax, unknown key, wrong type or range, missing asset, cycle.
SceneFile read_scene(const std::filesystem::path& path);
SceneFile parse_scene(const std::string& text, const std::filesystem::path& path);

/// Writes a scene for read_scene(), atomically.
void write_scene(const SceneFile& scene, const std::filesystem::path& path);

/// Canonical text; numbers are the shortest decimals that read back as the same float. `includes`: file names.
std::string scene_text(const SceneFile& scene, const std::vector<std::string>& includes = {});

/// Updates camera and knobs in a scene file and preserves the rest. Throws InputError if the file is invalid.
void update_scene(const SceneFile& scene, const std::filesystem::path& path);

/// Path of an asset: as given, else below assets/, else below the root. Throws InputError if none exists.
std::filesystem::path find_asset(const std::filesystem::path& path);

/// First object with such a model that is not hidden, nor below a hidden one; null: none.
const SceneObject* first_shown(const SceneFile& scene, bool (*is_such)(const std::filesystem::path& model));

/// Warns once about what a drawing that stands for a model's file leaves out of its objects: placement and motion, also
/// of their parents, and all objects but the first. `what`: "a volume".
void name_unused_placement(const SceneFile& scene, bool (*is_such)(const std::filesystem::path& model),
                           const char* what);

/// Transform to the parent's space at a time: scale, then spin, rotation, translation.
glm::mat4 local_transform(const SceneObject& object, float time_s = 0.0f);

}  // namespace lightwalk
