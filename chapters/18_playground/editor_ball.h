// The ball that shows the selection's material.
#pragma once
#include "18_playground/editor_part.h"
#include "18_playground/preview.h"
#include "common/base/epoch.h"

namespace lightwalk {

class MaterialBall : public EditorPart {
  public:
    using EditorPart::EditorPart;

    /// Shows the picture drawn last. Another one is due where the material has changed and nobody drags.
    void draw(EntryId id, const DrawItem& item);
    bool is_due() const { return due_.has_value(); }
    void make();  ///< the picture that is due, beside the frames

    Preview preview;

  private:
    static constexpr uint32_t size = 88;  ///< pixels
    std::optional<SceneFile> due_;
    Fingerprint made_;
    Fingerprint files_;
    Image8 picture_;
};

}  // namespace lightwalk
