#include "06_deferred/many_lights.h"

#include <cmath>
#include <numeric>

#include "01_obj/camera_view.h"
#include "01_obj/obj.h"
#include "03_attenuation/scattered_lights.h"
#include "common/base/error.h"

namespace lightwalk {

namespace {

constexpr const char* cube = "models/cube.obj";
constexpr float street_m = 12.0f, width_m = 9.0f, depth_m = 8.0f, yard_m = 5.0f;
constexpr int rows_to_crossing = 8;

// House with yard and pavement; the street is at x = 0, the house at +x.
class House {
  public:
    House(std::vector<SceneObject>& town, uint32_t number, glm::vec3 middle, bool faces_plus_x)
        : town_(town), number_(number), middle_(middle), turn_(faces_plus_x ? -1.0f : 1.0f) {}

    void build() {
        const float front = 0.5f * street_m, height = 5.5f + 1.5f * std::floor(4.0f * random(0));
        const glm::vec3 plaster = glm::mix(glm::vec3(0.62f, 0.5f, 0.36f), glm::vec3(0.72f, 0.7f, 0.66f), random(1)) *
                                  glm::mix(glm::vec3(1.0f, 0.8f, 0.7f), glm::vec3(0.9f, 1.0f, 1.0f), random(2));
        const glm::vec3 tiles = glm::mix(glm::vec3(0.3f, 0.1f, 0.06f), glm::vec3(0.2f, 0.17f, 0.16f), random(3));
        const glm::vec3 glass(0.05f, 0.08f, 0.12f), wood(0.16f, 0.09f, 0.05f);
        const float middle = front + 0.5f * depth_m, side = depth_m * 0.72f;
        add(cube, {middle, 0.5f * height, 0}, {depth_m, height, width_m}, plaster);
        add(cube, {middle, height, 0}, {side, side, width_m - 0.02f}, tiles, 45.0f);
        add(cube, {middle + 1.5f, height + 3.5f, 2.5f}, {0.8f, 3.0f, 0.8f}, 0.7f * plaster);
        add(cube, {front, 1.1f, -2.8f}, {0.2f, 2.2f, 1.2f}, wood);
        for (const float up : {1.9f, 4.6f})
            for (const float along : {-0.3f, 2.4f}) add(cube, {front, up, along}, {0.12f, 1.5f, 1.1f}, glass);
        add(cube, {front + depth_m + 1.5f, 1.0f, 3.6f * random(4) - 1.8f}, {2.0f, 2.0f, 2.5f}, wood);
        if (number_ % 6 == 0)
            add("models/column.obj", {front - 1.2f, 1.5f, 3.8f}, {0.35f, 1.0f, 0.35f}, glm::vec3(0.5f));
        else
            add(cube, {front - 0.9f, 0.3f, 1.2f}, {0.6f, 0.6f, 1.6f}, wood);
    }

  private:
    float random(uint32_t which) const { return scattered_number(1, number_, which); }
    void add(const char* model, glm::vec3 at, glm::vec3 size, glm::vec3 color, float turned_deg = 0.0f) {
        SceneObject& object = town_.emplace_back();
        object.model = model;
        object.position = middle_ + at * glm::vec3(turn_, 1.0f, 1.0f);
        object.rotation_deg = {0.0f, 0.0f, turned_deg};
        object.scale = size;
        object.material.diffuse = color;
        object.material.specular = glm::vec3(0.04f);
        object.material.shininess = 40.0f;
    }
    std::vector<SceneObject>& town_;
    const uint32_t number_;
    const glm::vec3 middle_;
    const float turn_;
};

}  // namespace

Screens::Screens(Module& owner, std::string name) : Module(owner, std::move(name), "screens") {}

std::vector<SceneObject> town_objects(int count) {
    std::vector<SceneObject> town;
    const auto wanted = static_cast<size_t>(std::max(count, 0));
    const int rows = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count) / 10.0)));
    const float street_pitch_m = street_m + 2.0f * depth_m + yard_m;
    for (int column = 0; town.size() < wanted; ++column) {  // outwards, on both sides of the first street
        const int street = column / 2;
        const float x = street_pitch_m * static_cast<float>((street + 1) / 2 * (street % 2 ? -1 : 1));
        for (int row = 0; row < rows; ++row) {
            const int crossings = row / rows_to_crossing - rows / 2 / rows_to_crossing;
            const float z = width_m * static_cast<float>(row - rows / 2) + street_m * static_cast<float>(crossings);
            House(town, static_cast<uint32_t>(column * rows + row), {x, 0.0f, -z}, column % 2 == 1).build();
        }
    }
    town.resize(wanted);
    return town;
}

void Town::prepare(Gpu& gpu, Scene& scene) {
    if (objects == 0) return;
    std::vector<SceneObject> all = scene.file.objects, town = town_objects(objects);
    std::vector<uint32_t> from(all.size());
    std::iota(from.begin(), from.end(), 0u);
    all.insert(all.end(), town.begin(), town.end());
    from.resize(all.size(), Scene::new_object);
    scene.replace_objects(gpu, std::move(all), from, [](const auto& file) { return load_model(file); });
}

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
    // 8 bits clamp to white, so that a screen showing itself cannot grow brighter.
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

void Screens::show(Scene& scene, bool before) {
    for (const auto& screen : screens_) {
        screen->shown = !before                   ? &screen->picture.now()
                        : screen->picture.valid() ? &screen->picture.before()
                                                  : &black_;
        // Non-owning: the scene binds this image for its items.
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
    if (screens_.empty()) return scene.opaque().batches();
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
