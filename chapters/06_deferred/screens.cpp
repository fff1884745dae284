#include "06_deferred/screens.h"

#include "01_obj/camera_view.h"
#include "common/base/error.h"

namespace lightwalk {
namespace {

size_t find_object(const SceneFile& file, const std::string& name) {
    size_t i = 0;
    while (i < file.objects.size() && file.objects[i].name != name) ++i;
    return i;
}

glm::mat4 object_to_world(const SceneFile& file, size_t object, float time_s) {
    const SceneObject& o = file.objects[object];
    const glm::mat4 local = local_transform(o, time_s);
    return o.parent.empty() ? local : object_to_world(file, find_object(file, o.parent), time_s) * local;
}

Camera camera_of(const SceneFile& file, size_t object, float time_s, float fov_deg) {
    const glm::mat4 world = object_to_world(file, object, time_s);
    const glm::vec3 eye(world[3]);
    return {.position = eye,
            .target = eye - glm::vec3(world[2]),
            .up = glm::vec3(world[1]),
            .fov_y_rad = glm::radians(fov_deg)};
}

}  // namespace

Screens::Screen::Screen(Module& owner, const std::string& name, glm::uvec2 size)
    // 8 bits make it a screen: white is the maximum, and a picture of itself cannot grow brighter.
    : picture(owner, {.name = name, .format = VK_FORMAT_R8G8B8A8_SRGB, .size = size}),
      depth(owner, {.name = name + " depth", .format = VK_FORMAT_D32_SFLOAT, .size = size}) {}

void Screens::prepare(Gpu& gpu, Scene& scene) {
    screens_.clear();
    black_ = Image(gpu.device, {.name = "black", .format = VK_FORMAT_R8G8B8A8_SRGB});
    const std::array<uint8_t, 4> black{0, 0, 0, 255};
    gpu.upload(black_, std::as_bytes(std::span(black)));
    const auto& objects = scene.file.objects;
    const auto size = glm::uvec2(width.value, width.value * 9 / 16);
    const Roles roles(scene.file);
    for (size_t i = 0; i < objects.size(); ++i) {
        if (!roles.is_screen(i)) continue;
        const std::string camera = roles.shown_by(i);
        auto& screen = screens_.emplace_back(std::make_unique<Screen>(*this, objects[i].name, size));
        screen->object = i;
        screen->camera = find_object(scene.file, camera);
        if (screen->camera == objects.size())
            throw InputError("{}: '{}' has no camera; add an object '{}'", scene.file.file.string(), objects[i].name,
                             camera);
    }
}

// [record]
void Screens::record(Frame& frame, Scene& scene, const Draw& draw) {
    show(scene, true);
    uint32_t id = 0;
    for (const auto& screen : screens_) {
        const Image& picture = screen->picture.now();
        View view = view_of(camera_of(scene.file, screen->camera, frame.time_s, fov_deg), picture.desc.size);
        view.id = views_.of(0, id++);
        light_.ensure(frame.gpu.device, {.name = path() + " light", .size = view.size});
        Canvas canvas(light_, screen->depth, glm::vec4(scene.file.background, 1.0f));
        const ViewScope scope(frame, view);
        draw(view, canvas);
        frame.compute(scene.file.objects[screen->object].name,
                      {.reads = {canvas.color(frame)}, .writes = {ImageView(picture).codes()}}, [&](Compute& pass) {
                          pass.use(encode_).set("hdr", light_, nearest_clamp);
                          pass.set("result", ImageView(picture).codes()).dispatch_threads(view.size);
                      });
    }
    show(scene, false);
}
// [/record]

void Screens::show(Scene& scene, bool before) {
    for (const auto& screen : screens_) {
        screen->shown = !before                   ? &screen->picture.now()
                        : screen->picture.valid() ? &screen->picture.before()
                                                  : &black_;
        // The scene binds its items' images; ownership of the image stays here.
        const std::shared_ptr<Image> image(std::shared_ptr<Image>(), const_cast<Image*>(screen->shown));
        for (DrawItem& item : scene.items)
            if (item.object == screen->object) item.maps[MapSlot::diffuse] = item.maps[MapSlot::emissive] = image;
    }
}

bool Screens::is_screen(const DrawItem& item) const {
    for (const auto& screen : screens_)
        if (item.object == screen->object) return true;
    return false;
}

std::vector<Batch> Screens::batches(const Scene& scene) const {
    if (screens_.empty()) return scene.opaque_batches();
    std::vector<Batch> all = scene.opaque().where([&](const DrawItem& item) { return !is_screen(item); }).batches();
    for (uint32_t i = 0; i < scene.items.size(); ++i)
        if (is_screen(scene.items[i]) && !scene.items[i].transparent) all.emplace_back(scene, i, 1u);
    return all;
}

std::vector<Resource> Screens::reads() const {
    std::vector<Resource> all;
    for (const auto& screen : screens_)
        if (screen->shown && screen->shown != &black_) all.emplace_back(*screen->shown);
    return all;
}

}  // namespace lightwalk
