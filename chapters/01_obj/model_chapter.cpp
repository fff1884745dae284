#include "01_obj/model_chapter.h"

namespace lightwalk {

Model ModelChapter::load_model(const std::filesystem::path& file) {
    Model own;
    return any_proxy(file, own) ? own : lightwalk::load_model(file, loader(), static_cast<Tr>(mtl.tr.index));
}

std::vector<std::string> ModelChapter::load_exercises() const {
    return {"01.parse_vertex_line", "01.parse_face", "01.triangulate"};
}

View ModelChapter::set_view(Frame& frame, const Camera& from) {
    animate(scene, frame.time_s);
    scene.upload_moved(frame);
    const View view = view_of(from, frame);
    look_from(view, frame);
    return view;
}

}  // namespace lightwalk
