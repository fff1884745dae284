// Head drawing: skin, eyes and matt parts, under lights with shadows and an environment.
#pragma once
#include "05_shadow_maps/lit_scene.h"
#include "12_skin/skin.h"
#include "common/app/environment.h"
#include "common/app/world.h"

namespace lightwalk {

/// The scene of `objects`, drawn as skin under its lights; they are not drawn themselves. Its modules are the owner's:
/// skin.*, rays.*, and backdrop.
struct Head : Drawing {
    Head(Module& owner, std::string name, LitScene& objects, EnvironmentLight& environment);

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

  private:
    LitScene& objects_;
    EnvironmentLight& environment_;
    const Scene* scene_ = nullptr;
    Pipeline backdrop_ = compute({.shader = "12_skin/backdrop.comp"});
};

struct Portrait : World {
    explicit Portrait(Module& owner) : World(owner) { objects.maps.method.change_default("normal"); }

    LitScene objects{*this, "objects", Shading{}};  // its lights and maps; only the head is drawn
    EnvironmentLight environment{*this, "environment"};
    Head head{*this, "head", objects, environment};
    Knob<float> dolly{*this, "dolly", 1.0f, {0.2f, 64.0f}, "Scale factor for the distance of the camera"};

    Drawings drawings() override { return {head}; }
    Eye eye(const Frame&, const Camera& given) override {
        Camera there = given;
        there.position = glm::mix(given.target, given.position, dolly.value);
        return {there};
    }
    std::vector<std::pair<std::string, std::string>> look() const override {
        return {{"bloom.method", "none"}, {"post.tone", "off"}};
    }
};

}  // namespace lightwalk
