// A scene on the device: models placed by a scene file, drawn in batches of equal parts.
#pragma once
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/bare.h"
#include "common/scene/draw_list.h"
#include "common/scene/material_maps.h"
#include "common/scene/model_pool.h"

namespace lightwalk {

/// A part of a mesh, placed.
struct DrawItem {
    std::shared_ptr<GpuModel> model;
    uint32_t mesh = 0, part = 0;
    uint32_t object = 0, node = 0;  ///< of SceneFile::objects, and of the model's nodes
    glm::mat4 transform{1.0f};      ///< object to world
    Bounds bounds;                  ///< world space
    bool mirrored = false;          ///< the transform turns counter-clockwise into clockwise
    /// Blends with its background: opacity below 1, or a blending alpha of the material. An item with holes cut by an
    /// opacity map or alpha texture stays opaque.
    bool transparent = false;
    MaterialMaps maps;
    MapImages loaded_maps;  ///< as the pool has them: modules may put others into `maps`
    MaterialNumbers material;
    Role role = Role::plain;
    float roughness = -1, metalness = -1;  ///< instead of a map's; below 0: neither scene nor model says
    bool two_sided = false;                ///< its back is drawn, too
};

/// The model's material, with its maps.
const Material& own_material(const DrawItem& item);

/// Its data for shaders; `index` is its position in Scene::items.
Instance instance_of(const DrawItem& item, size_t index);

/// Directional light and the mean sky, exposed, in the unit of the scene.
struct Sun {
    glm::vec3 to_sun{0.0f, 1.0f, 0.0f};  ///< unit length, world space
    glm::vec3 light{0.0f};               ///< irradiance of a facing surface; its radiance if white, times pi
    glm::vec3 sky{0.0f};                 ///< radiance from everywhere else, in the mean
    bool operator==(const Sun&) const = default;
};

class Scene : public Drawable {
  public:
    SceneFile file;
    Bounds bounds;  ///< world space

    /// Items of one batch are adjacent, transparent ones last; otherwise in file order. gl_InstanceIndex is the
    /// position in here.
    std::vector<DrawItem> items;

    /// The image of the scene file's `environment`: equirectangular, linear RGBA16F with all mips. Null if the file
    /// names none. Its intensity and rotation are in `file`.
    std::shared_ptr<Image> environment;

    /// Loads models and textures and places them as at 0 s. Throws InputError.
    void load(Gpu& gpu, SceneFile scene, const ModelLoader& loader);

    // Edits of a loaded scene.

    /// Where an object stands in its parent's space.
    struct Move {
        uint32_t object;  ///< of file.objects
        glm::vec3 position, rotation_deg, scale;
    };

    /// Places these objects and their children; upload_moved() tells the device.
    void move(std::span<const Move> moves);

    /// Gives objects other materials of the same textures, ways of shading and kinds of transparency: only numbers
    /// differ, and no list is made. upload_moved() tells the device. False, without any change, for other materials.
    struct Paint {
        uint32_t object;  ///< of file.objects
        MaterialOverride material;
    };
    bool paint(std::span<const Paint> paints);

    /// Gives every item's material the file's `bare` and `emission` as they are now; as paint(). False: some are of
    /// another kind, and their maps are the pool's again; replace_objects() has to make the lists.
    bool repaint(bool bare, float emission);

    /// Replaces the objects. `from`: for each its index in file.objects before, or `new_object`. Objects with the
    /// same model, material and role are not loaded again; other models and textures come from the pools. Throws
    /// InputError as load(), without any change. Returns whether modules have to prepare again, for a new model or
    /// material. Afterwards all items' maps are the pool's again.
    bool replace_objects(Gpu& gpu, std::vector<SceneObject> objects, std::span<const uint32_t> from,
                         const ModelLoader& loader);
    static constexpr uint32_t new_object = ~0u;

    /// The environment that `file` names now. Throws InputError.
    void replace_environment(const Environment& other);

    /// The common sun of everything drawn together: the file's first directional light and its ambient light, unless
    /// a sky replaces it. Black without either.
    Sun sun() const;
    void set_sun(const Sun& sun) { sky_sun_ = sun; }
    void forget_sun() { sky_sun_.reset(); }  ///< there is no sky any more

    /// The file's, the first directional one as sun() has it; the same list until one of them changes.
    const LightList& lights() const;
    glm::vec3 ambient() const { return sun().sky; }

    /// Draws every item, as DrawList::draw.
    void draw(Raster& pass) const override { all().draw(pass); }

    DrawList all() const;
    DrawList opaque() const;
    DrawList transparent() const;
    std::vector<Batch> opaque_batches() const;  ///< opaque().batches(), found once
    std::vector<Batch> batches() const { return all().batches(); }

    /// Whether animate() has anything to do.
    bool moves() const { return !moving_items_.empty(); }

    /// Epoch of the last load, edit or motion of anything in it; unique to a scene.
    uint64_t epoch = 0;

    /// Records the upload of the instances that have moved since the last one, and of materials that were painted;
    /// nothing if there are none.
    void upload_moved(Frame& frame);

    Buffer instances, materials, placements;  ///< placements: MAP_COUNT for each item, where one is not plain
    size_t triangle_count() const;

    /// The item's texture; without one it is a white texel, or a flat normal.
    const Image& texture(const DrawItem& item, MapSlot slot) const;

    /// Equal for items of one batch.
    uint32_t batch_of(uint32_t item) const { return batch_of_[item]; }

    /// Forgets pools too: the next load reads every file again.
    void clear();

    const ModelPool& models() const { return models_; }
    ModelPool& models() { return models_; }
    const ImagePool* images() const { return images_.get(); }
    ImagePool& images(Gpu& gpu);

  private:
    friend void animate(Scene& scene, float time_s);
    struct Placed {
        int parent = -1;  ///< an earlier object
        bool moves = false, hidden = false;
        glm::mat4 local{1.0f}, world{1.0f};  ///< local: of an object without a motion of its own
    };
    void add_items(Gpu& gpu, size_t object, const Roles& roles, const ModelLoader& loader);
    void load_environment();
    void link_objects();
    void place_and_upload(Gpu& gpu);
    bool place(DrawItem& item) const;
    void place_objects(float time_s);
    void sort_items();
    void find_batches();
    void find_items();
    std::vector<Placed> objects_;
    std::vector<uint32_t> first_item_, items_of_;  ///< of each object; its items are those from its first to the next's
    float time_s_ = 0;
    std::optional<Sun> sky_sun_;
    mutable LightList lights_;
    std::vector<std::shared_ptr<GpuModel>> moving_models_;
    std::set<const GpuModel*> deforming_;  ///< the ones with meshes to deform
    bool to_deform_ = false;
    std::vector<uint32_t> moving_items_, batch_of_;
    std::vector<bool> to_upload_, to_paint_;
    uint64_t uploaded_ = 0;                                           ///< epoch
    mutable std::vector<std::pair<uint32_t, uint32_t>> opaque_runs_;  ///< of batches: first item, items
    size_t first_transparent_ = 0;
    ModelPool models_;
    std::unique_ptr<ImagePool> images_;
    std::shared_ptr<Image> white_, flat_;
    std::set<std::string> warned_;  ///< textures that could not be read: each is said once
};

/// Places every object and every model's nodes for that time, independent of earlier calls; updates bounds. Objects
/// move by the `motion` of the scene file, nodes by the first animation of their model file; children follow their
/// parents. Data made from the scene's items (batches, the order of lists) must be rebuilt.
void animate(Scene& scene, float time_s);

/// Records the passes that put the vertices of a model's deformed meshes where they are at that time; its nodes are there.
void deform_model(Frame& frame, GpuModel& model, float time_s);

template <class Predicate>
DrawList DrawList::where(Predicate predicate) const {
    std::vector<uint32_t> kept;
    kept.reserve(items_.size());
    for (const uint32_t i : items_)
        if (predicate(scene_->items[i])) kept.push_back(i);
    return {*scene_, std::move(kept)};
}

}  // namespace lightwalk
