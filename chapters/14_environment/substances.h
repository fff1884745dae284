// Properties of a model's materials beyond chapter 04's numbers, as a module.
#pragma once
#include "common/app/module.h"
#include "common/scene/scene.h"

namespace lightwalk {

/// Gives shaders the buffer `substances` of 14_environment/substance_data.h, an entry for each of the scene's items.
struct Substances : Module {
    Substances(Module& owner, std::string name) : Module(owner, std::move(name), "substance") {}

    Knob<float> roughness{
        *this, "roughness", -1.0f, {-1.0f, 1.0f}, "Roughness of all surfaces; below 0 each has its own"};

    void prepare(Gpu& gpu, Scene& scene) override;
    std::vector<Resource> reads() const override { return {substances_}; }
    void bind(Pass& pass) const override { pass.set_if_present("substances", substances_); }

  private:
    Buffer substances_;
};

}  // namespace lightwalk
