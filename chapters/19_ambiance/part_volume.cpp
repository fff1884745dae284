// Chapter 16's nebula in a ball of glass between turning rings.
#include "04_surface_maps/surface_scene.h"
#include "09_post_effects/depth_of_field.h"
#include "16_volume/finish.h"
#include "16_volume/volume.h"
#include "16_volume/volume_file.h"
#include "19_ambiance/part.h"

namespace lightwalk {
namespace {

struct VolumePart : FilmPart {
    VolumePart(const FilmScene& scene, Music& music) : FilmPart(scene, music) {
        bloom.method.change_default("pyramid");
        objects.maps.method.change_default("flat");
    }
    Finish finish{*this, "finish"};  // before the maps' levels are made of it
    SurfaceScene objects{*this, "objects"};
    Volume volume{*this, "volume"};
    DepthOfField dof{*this, "dof"};

    Model load_model(const std::filesystem::path& file) override {
        if (is_lathe_file(file)) {
            const Lathe lathe = read_lathe(file);
            return lathe_model(lathe, turn_lathe(lathe));
        }
        if (!is_volume_file(file)) return FilmPart::load_model(file);
        Model none;  // the volume itself reads the file
        none.materials.emplace_back();
        return none;
    }

    void draw_light(Frame& frame, const Camera& camera) override {
        const View view = look(frame, camera);
        Canvas canvas(frame.hdr, frame.depth, glm::vec4(scene_.file.background, 1.0f));
        dof.record(frame, view, canvas, {objects});
        draw(frame, view, canvas, {volume});
    }
};

}  // namespace

std::unique_ptr<FilmPart> make_volume(const FilmScene& scene, Music& music) {
    return std::make_unique<VolumePart>(scene, music);
}

}  // namespace lightwalk
