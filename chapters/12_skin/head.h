// Head drawing: skin, eyes and matt parts, under lights with shadows and an environment.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "12_skin/skin.h"
#include "common/app/environment.h"

namespace lightwalk {

// [head]
/// The scene of `objects`, drawn as skin under its lights; they are not drawn themselves. Its modules are the owner's:
/// skin.*, rays.*, and backdrop.
struct Head : Drawing {
    Head(Module& owner, std::string name, LitScene& objects, EnvironmentLight& environment)
        : Drawing(owner, std::move(name)),
          skin(owner, "skin"),
          rays(owner, "rays"),
          backdrop(owner, "backdrop", 4.5f, {0.0f, 8.0f},
                   "which level of the environment is seen behind: more is blurrier"),
          objects_(objects),
          environment_(environment) {}

    Skin skin;
    SceneRays rays;
    Knob<float> backdrop;
    Skin::Shown shown = Skin::Shown::all;

    void prepare(Gpu&, Scene& loaded) override { scene_ = &loaded; }
    std::vector<const Module*> dependencies() const override {
        return {&skin, &rays, &objects_.maps, &objects_.lights, &objects_.shadow, &environment_};
    }
    void update(Frame& frame) override;
    void draw(Frame& frame, const View& view, Canvas& canvas) override;
    // [/head]

  private:
    LitScene& objects_;
    EnvironmentLight& environment_;
    const Scene* scene_ = nullptr;
    Pipeline backdrop_ = compute({.shader = "12_skin/backdrop.comp"});
};

}  // namespace lightwalk
