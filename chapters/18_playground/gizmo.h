// The gizmo's mathematics: handles, the one under the mouse, and a drag's effect on the selection.
#pragma once
#include "18_playground/commands.h"
#include "common/scene/view.h"

namespace lightwalk {

enum class Tool { move, rotate, scale };

/// `axis` 0 to 2: an axis, or the plane across it, or the ring about it. `whole`: along the picture's plane, about the
/// direction of view, or all axes alike.
struct Handle {
    enum class Kind { nothing, axis, plane, ring, whole } kind = Kind::nothing;
    int axis = 0;
    bool operator==(const Handle&) const = default;
    explicit operator bool() const { return kind != Kind::nothing; }
};

struct GizmoPlace {
    Tool tool = Tool::move;
    glm::vec3 pivot{0.0f};  ///< metres, world space
    glm::mat3 axes{1.0f};   ///< unit length, world space
    float length_m = 1;     ///< of an arrow: as many pixels everywhere
    float scale = 1;        ///< of GizmoSizes
};

/// In pixels.
struct GizmoSizes {
    float arrow = 90, plane = 28, reach = 7;
};

/// The gizmo of the selection: in its middle, or for a sun, which is turned only, at the camera's target; along the
/// world's axes or those of the active object.
std::optional<GizmoPlace> gizmo_place(const Document& document, const Selection& selection, const View& view, Tool tool,
                                      bool local, float scale = 1.0f);

/// A handle's outline in the world, as a line through these points.
std::vector<glm::vec3> handle_line(const GizmoPlace& place, const Handle& handle, const View& view);
std::vector<Handle> handles(Tool tool);

/// Seen so nearly from its end (an axis) or its edge (a plane, a ring) that it is neither drawn nor picked: within 8°.
bool is_end_on(const GizmoPlace& place, const Handle& handle, const View& view);

/// Under the mouse, or none. Pixels of the view's picture.
Handle handle_at(const GizmoPlace& place, const View& view, glm::vec2 cursor_px);

/// Pixels; nothing behind the camera.
std::optional<glm::vec2> on_screen(const View& view, const glm::vec3& place);
PickRay ray_through(const View& view, glm::vec2 cursor_px);

/// A drag from the press of the button to its release: one step of the document. Each move starts from where things
/// were at the beginning, so that nothing adds up, and a mouse that comes back brings everything back, to the bit.
class GizmoDrag {
  public:
    GizmoDrag(Document& document, const std::vector<EntryId>& ids, const GizmoPlace& place, const Handle& handle,
              const View& view, glm::vec2 cursor_px);

    /// `snap`: in steps of the tool's: 0.1 of an arrow's power of ten, 15°, or a tenth.
    void move(const View& view, glm::vec2 cursor_px, bool snap);
    void finish();                                       ///< one step
    void cancel();                                       ///< as it was
    const std::string& words() const { return words_; }  ///< the drag so far: "1.25 m along x"

  private:
    struct Start {
        EntryId id;
        glm::dmat4 parent;  ///< to the world
        Placement placement;
        glm::dquat parent_rotation;
        bool mirrored = false;  ///< by the parent
        glm::vec3 light_position{0.0f}, light_direction{0.0f};
    };
    void translate(const glm::dvec3& by);
    void rotate(const glm::vec3& axis, double angle_rad);
    void scale(const glm::dvec3& by);
    void follow(const View& view);
    float place_on_axis(const View& view, glm::vec2 cursor_px) const;
    glm::vec3 place_on(const View& view, glm::vec2 cursor_px) const;
    std::optional<float> angle_on(const View& view, glm::vec2 cursor_px) const;
    Document& document_;
    std::vector<Start> starts_;
    GizmoPlace place_;
    Handle handle_;
    glm::vec3 normal_{0.0f};  ///< of the plane that a plane handle, a ring or the whole is dragged in
    float start_on_axis_ = 0, angle_ = 0, last_angle_ = 0;
    glm::vec3 start_place_{0.0f};
    glm::vec2 start_px_{0.0f}, last_px_{0.0f};
    View view_;  ///< of the last move
    std::string words_;
};

}  // namespace lightwalk
