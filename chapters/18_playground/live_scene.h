// The document's changes, carried over to the scene on the device.
#pragma once
#include <functional>
#include <optional>

#include "18_playground/saving.h"
#include "common/base/error.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Updates a loaded scene from a document with minimal work: moves and paints items; copies lights; other objects,
/// models, textures and hidden entries go through Scene::replace_objects().
class LiveScene {
  public:
    /// The scene shows this document from now on; it was loaded with exported(document).scene.
    void begin(Document& document, Scene& scene);

    /// Applies the document's changes to the scene; true if objects were replaced, so that modules have to be prepared.
    /// Throws InputError where a model or a texture cannot be read: the scene is as it was then.
    /// With `without`, models, textures and an environment that cannot be read are left out of the picture, not out of
    /// the document, and `without` says which and why.
    bool update(Gpu& gpu, Document& document, Scene& scene, const ModelLoader& loader,
                std::vector<std::string>* without = nullptr);

    bool loads = false;  ///< of the last update(): modules have something to prepare

    EntryId entry_of(uint32_t object) const { return object < objects_.size() ? objects_[object] : no_entry; }
    uint32_t object_of(EntryId id) const;  ///< of SceneFile::objects; Scene::new_object: none
    const std::vector<EntryId>& lights() const { return lights_; }

  private:
    void number(const Exported& all);
    void leave_out(Gpu& gpu, Scene& scene, std::vector<SceneObject>& objects, const std::vector<uint32_t>& from,
                   const ModelLoader& loader, const std::function<void(const InputError&)>& note) const;
    /// Edits that need no other lists.
    struct Edits {
        std::vector<Scene::Edit> objects;
        std::vector<EntryId> lights;
    };
    std::optional<Edits> edits_of(const Document& document, const Scene& scene,
                                  const std::vector<EntryId>& entries) const;
    std::vector<EntryId> objects_, lights_;
    std::unordered_map<EntryId, uint32_t> places_, light_places_;
};

}  // namespace lightwalk
