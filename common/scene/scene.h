// Scene on the device: models placed by a scene file, drawn in batches.
#pragma once
#include "common/base/epoch.h"
#include "common/gpu/frame.h"
#include "common/scene/bare.h"
#include "common/scene/draw_list.h"
#include "common/scene/material_maps.h"
#include "common/scene/model_pool.h"

namespace lightwalk {

/// Instance of a mesh part.
struct DrawItem {
    std::shared_ptr<GpuModel> model;
    uint32_t mesh = 0, part = 0;
    uint32_t object = 0, node = 0;  ///< indices into SceneFile::objects and Model::nodes
    glm::mat4 transform{1.0f};
    Bounds bounds;          ///< world space
    bool mirrored = false;  ///< transform reverses the winding
    /// Blended: opacity below 1, or a blending material. Items with holes cut by alpha are opaque.
    bool transparent = false;
    MaterialMaps maps;
    MapImages loaded_maps;  ///< textures of the pool, which modules may replace in `maps`
    MaterialNumbers material;
    Role role = Role::plain;
    float roughness = -1, metalness = -1;  ///< values that replace textures; negative: unspecified
    bool two_sided = false;
};

const Material& own_material(const DrawItem& item);

/// Sets material and transparency of an item whose maps are set. `bare`: SceneFile::bare.
void set_material(DrawItem& item, const MaterialOverride& with, bool bare);

MaterialData material_data(const DrawItem& item, float emission);

Instance instance_of(const DrawItem& item, size_t index);

/// Directional light and mean sky, exposed, in scene units.
struct Sun {
    glm::vec3 to_sun{0.0f, 1.0f, 0.0f};  ///< unit length, world space
    glm::vec3 light{0.0f};               ///< irradiance of a facing surface = pi × radiance of a white one
    glm::vec3 sky{0.0f};                 ///< mean radiance of the rest of the sky
    bool operator==(const Sun&) const = default;
};

class Scene : public Drawable {
  public:
    SceneFile file;
    Bounds bounds;  ///< world space

    /// Batches are contiguous, transparent items last, otherwise in file order. gl_InstanceIndex is the index.
    std::vector<DrawItem> items;

    /// Equirectangular linear RGBA16F image with all mips; null: none. Intensity and rotation are in `file`.
    std::shared_ptr<Image> environment;

    /// Loads models and textures and places them at 0 s. Throws InputError.
    void load(Gpu& gpu, SceneFile scene, const ModelLoader& loader);

    struct Edit {
        uint32_t object;  ///< index into file.objects
        const SceneObject* now;
    };
    /// Takes over placements, with those of children, and material values. False: no change, since a texture or kind of
    /// material differs. Requires upload_moved().
    bool edit(std::span<const Edit> edits);

    /// Applies changed `bare` and `emission` to all items. False: some need other lists, call replace_objects().
    bool repaint(bool bare, float emission);

    /// Replaces the objects. `from`: previous index in file.objects, or `new_object`. Objects with equal model,
    /// material and role keep their items; the rest comes from the pools or is loaded. All maps are reset to the
    /// pool's. Returns true if modules must prepare again. Throws InputError without any change.
    bool replace_objects(Gpu& gpu, std::vector<SceneObject> objects, std::span<const uint32_t> from,
                         const ModelLoader& loader);
    static constexpr uint32_t new_object = ~0u;

    /// Loads another environment. Throws InputError.
    void replace_environment(const Environment& other);

    /// Sun of the scene: set_sun()'s, else the file's first directional light and ambient light; black without these.
    Sun sun() const;
    void set_sun(const Sun& sun) { sky_sun_ = sun; }
    void forget_sun() { sky_sun_.reset(); }

    /// Lights of the file, with sun() as the first directional one. The pointer changes with the contents.
    const LightList& lights() const;
    glm::vec3 ambient() const { return sun().sky; }

    void draw(Raster& pass) const override { all().draw(pass); }

    DrawList all() const;
    DrawList opaque() const;
    DrawList transparent() const;
    std::vector<Batch> batches() const { return all().batches(); }

    bool moves() const { return !moving_items_.empty(); }

    /// Epoch of the last load, edit or motion; unique among scenes.
    uint64_t epoch = 0;

    /// Records the upload of moved instances and repainted materials, if any.
    void upload_moved(Frame& frame);

    Buffer instances, materials, placements;  ///< placements: MAP_COUNT per item, if any texture has a transform
    size_t triangle_count() const;

    /// Texture of an item; default: white, or a flat normal.
    const Image& texture(const DrawItem& item, MapSlot slot) const;

    /// Equal for items of one batch.
    uint32_t batch_of(uint32_t item) const { return batch_of_[item]; }

    /// Clears the pools, too: the next load reads all files.
    void clear();

    const ModelPool& models() const { return models_; }
    ModelPool& models() { return models_; }
    const ImagePool* images() const { return images_.get(); }
    ImagePool& images(Gpu& gpu);

  private:
    friend void animate(Scene& scene, float time_s);
    struct Placed {
        int parent = -1;
        bool moves = false, hidden = false;
        glm::mat4 local{1.0f}, world{1.0f};
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
    void move(std::vector<bool> moved);  ///< by index into file.objects
    std::vector<Placed> objects_;
    std::vector<uint32_t> first_item_, items_of_;
    float time_s_ = 0;
    std::optional<Sun> sky_sun_;
    mutable LightList lights_;
    std::vector<std::shared_ptr<GpuModel>> moving_models_;
    std::set<const GpuModel*> deforming_;
    bool to_deform_ = false;
    std::vector<uint32_t> moving_items_, batch_of_;
    std::vector<bool> to_upload_, to_paint_;
    uint64_t uploaded_ = 0;
    size_t first_transparent_ = 0;
    ModelPool models_;
    std::unique_ptr<ImagePool> images_;
    std::shared_ptr<Image> white_, flat_;
    std::set<std::string> warned_;
};

/// Places objects and model nodes at a time, and updates bounds. Invalidates batches and orders of items.
void animate(Scene& scene, float time_s);

/// Records the deformation of a model's meshes. Its nodes must be at `time_s`.
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
