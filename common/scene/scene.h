// A scene on the device: models placed by a scene file, drawn part by part.
#pragma once
#include <functional>
#include <memory>
#include <set>

#include "common/gpu/pass.h"
#include "common/scene/image_pool.h"
#include "common/scene/mesh.h"
#include "common/scene/scene_file.h"

namespace lightwalk {

using ModelLoader = std::function<Model(const std::filesystem::path&)>;

/// A model as loaded and its buffers: for each mesh one of vertices and one of indices.
struct GpuModel {
    Model model;
    std::vector<Buffer> vertices, indices;

    /// What a chapter adds to vertices: by binding, a buffer for each mesh.
    std::map<std::string, std::vector<Buffer>> attributes;
};

/// Models by file, each loaded and uploaded once.
class ModelPool {
  public:
    std::shared_ptr<GpuModel> load(Gpu& gpu, const std::filesystem::path& file, const ModelLoader& loader);
    void clear() { models_.clear(); }
    size_t size() const { return models_.size(); }

  private:
    std::map<std::string, std::shared_ptr<GpuModel>> models_;
};

/// One draw call: a part of a mesh, placed.
struct DrawItem {
    std::shared_ptr<GpuModel> model;
    uint32_t mesh = 0, part = 0;
    glm::mat4 transform{1.0f};  ///< object to world
    Bounds bounds;              ///< world space
    Material material;
    float roughness = -1, metalness = -1;  ///< the scene file's, instead of a map's; below 0: it says nothing
    std::map<std::string, std::shared_ptr<Image>> maps;  ///< by binding, such as "diffuse_map"
};

class Scene : public Drawable {
  public:
    SceneFile file;
    Bounds bounds;  ///< world space
    std::vector<DrawItem> items;

    /// Loads models and textures. Throws InputError.
    void load(Gpu& gpu, SceneFile scene, const ModelLoader& loader);

    /// Binds `vertices` and the model's attributes, `instances`, `materials` and those of the material's textures that
    /// the shader names, and draws every item. A texture that a material lacks is one white texel (a flat normal for
    /// normal maps).
    void draw(Raster& pass) const override;
    void draw(Raster& pass, const DrawItem& item) const;

    /// Binds that for an item which is drawn otherwise; gl_InstanceIndex has to be the item's place in `items`.
    void bind(Raster& pass, const DrawItem& item) const;

    Buffer instances, materials;
    size_t triangle_count() const;

    /// Forgets pools too: the next load reads every file again.
    void clear();

    const ModelPool& models() const { return models_; }
    const ImagePool* images() const { return images_.get(); }

  private:
    void place(Gpu& gpu, const SceneObject& object, const glm::mat4& world, const ModelLoader& loader);
    ModelPool models_;
    std::unique_ptr<ImagePool> images_;
    std::shared_ptr<Image> white_, flat_;
    std::set<std::string> warned_;  ///< textures that could not be read: each is said once
};

/// A scene that shows one model: a camera that frames it, a key and a fill light. `bounds` in metres.
SceneFile scene_of_model(const std::filesystem::path& model, const Bounds& bounds);

}  // namespace lightwalk
