// G-buffer module: the surface of each pixel, written once and lit later.
#pragma once
#include <map>

#include "common/app/module.h"
#include "common/gpu/frame.h"
#include "common/scene/view.h"

namespace lightwalk {

/// GLSL: read_pixel() of 06_deferred/read_gbuffer.glsl. Per view: begin(), a pass into targets() with the module in
/// `.with`, written(); then passes that read it with the module in `.with` and the view's depth in `.reads`.
struct GBuffer : Module {
    GBuffer(Module& owner, std::string name) : Module(owner, std::move(name), "gbuffer") {}

    Choice method{*this,
                  "method",
                  {"forward", "fat", "depth", "packed", "tiled"},
                  "packed",
                  "Shading path: forward (no G-buffer), or a G-buffer of 40 bytes a pixel (fat), 24 without position "
                  "(depth), or 12 (packed; tiled: lit by tiles)"};
    Choice normal_bits{*this,
                       "normal_bits",
                       {"8", "12", "16"},
                       "8",
                       "Bits for each of the two components of a packed normal; the mesh normal gets the rest of 32"};
    Knob<bool> volumes{*this, "volumes", true,
                       "Light volumes: each light drawn as a sphere or cone; off: every light for every pixel"};
    Choice show{*this,
                "show",
                {"picture", "normal", "facing", "diffuse", "specular", "gloss", "occlusion", "position", "depth",
                 "lights", "loss"},
                "picture",
                "View: the picture, one decoded channel of the G-buffer, the number of lights (127 is white), or the "
                "encoding error (loss: degrees of normals in red, millimetres of positions in green)"};

    /// Images of the view's size for the method, one set per View::id. `depth`: the view's.
    void begin(Frame& frame, const View& view, const ImageView& depth);

    /// Render targets, not cleared: pixels with depth 0 are never read. `again`: keeps their contents.
    std::vector<Attachment> targets(bool again = false) const;
    void written() { written_ = true; }

    /// Bytes a pixel beside depth; 0 for forward.
    uint32_t bytes_per_pixel() const;

    bool is_forward() const { return method.is("forward"); }
    bool shows_loss() const { return show.is("loss"); }

    std::vector<Resource> reads() const override;
    void bind(Pass& pass) const override;
    std::vector<std::string> status() const override;

  private:
    struct Texture {
        std::string name;  ///< gbuffer_<name> in shaders
        VkFormat format;
    };
    std::vector<Texture> textures() const;
    std::map<std::pair<uint32_t, std::string>, Image> made_;    ///< by view and name
    std::vector<std::pair<std::string, const Image*>> images_;  ///< images of this view, by their names in shaders
    ImageView depth_;
    glm::mat4 clip_to_offset_{1.0f};
    bool written_ = false;
};

/// Clip space to vectors from the eye: inverse of the view's matrix with the eye as the origin.
glm::mat4 clip_to_offset(const glm::mat4& view_projection, glm::vec3 eye);

}  // namespace lightwalk
