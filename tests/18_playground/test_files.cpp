// Files of the editor without its window: models that are read on a thread, and where thumbnails are kept.
#include <thread>

#include "01_obj/obj.h"
#include "04_surface_maps/maps.h"
#include "04_surface_maps/tangents.h"
#include "18_playground/background_load.h"
#include "18_playground/preview.h"
#include "common/base/guarded.h"
#include "editor_fixture.h"

using namespace lightwalk;

namespace {

// A square of side * side quads with texture coordinates.
std::string grid_text(int side) {
    std::string text;
    for (int y = 0; y <= side; ++y)
        for (int x = 0; x <= side; ++x) text += fmt::format("v {} {} {}\nvt {} {}\n", x, (x * y) % 3, y, x, y);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int a = y * (side + 1) + x + 1, b = a + side + 1;
            text += fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", a, a + 1, b + 1, b);
        }
    return text;
}

BackgroundLoad::Ended waited_for(BackgroundLoad& load) {
    for (int i = 0; i < 6000; ++i) {
        if (auto ended = load.poll()) return *ended;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    FAIL("it does not end");
    return {};
}

}  // namespace

TEST_CASE("a model that is read on a thread is the one that would be loaded, with its tangents") {
    const FileFolder folder;
    const auto file = folder.path / "grid.obj";
    write_file(file, grid_text(40));
    BackgroundLoad load;
    load.start(file);
    CHECK(load.busy());
    const BackgroundLoad::Ended ended = waited_for(load);
    REQUIRE(ended.model);
    CHECK_FALSE(load.busy());
    Model expected = load_model(file);
    const auto frames = frame_model(expected);
    const Mesh &mesh = ended.model->model.meshes.at(0), &other = expected.meshes.at(0);
    CHECK(mesh.indices == other.indices);
    REQUIRE(mesh.vertices.size() == other.vertices.size());
    REQUIRE(ended.model->frames.at(0).size() == frames.at(0).size());
    for (size_t i = 0; i < frames[0].size(); ++i) CHECK(ended.model->frames[0][i].tangent == frames[0][i].tangent);
}

TEST_CASE("a file that cannot be read is one line, and the next one is read all the same") {
    const FileFolder folder;
    write_file(folder.path / "bad.obj", "v 0 0 0\nf 1 2 3\n");
    write_file(folder.path / "good.obj", grid_text(2));
    BackgroundLoad load;
    load.start(folder.path / "bad.obj");
    const BackgroundLoad::Ended bad = waited_for(load);
    CHECK_FALSE(bad.model);
    CHECK(bad.error.find("bad.obj:2") != bad.error.npos);
    CHECK(bad.error.find('\n') == bad.error.npos);
    load.start(folder.path / "good.obj");
    CHECK(waited_for(load).model);
}

TEST_CASE("what is cancelled ends early and is never delivered; progress is a share of a stage") {
    const FileFolder folder;
    const auto file = folder.path / "large.obj";
    write_file(file, grid_text(700));
    BackgroundLoad load;
    // Of this process, in all its threads.
    const auto process_ms = [] { return 1e3 * double(std::clock()) / CLOCKS_PER_SEC; };
    double start = process_ms();
    load.start(file);
    float most = 0;
    while (!load.poll()) {
        most = std::max(most, load.share());
        CHECK(load.share() >= 0.0f);
        CHECK(load.share() <= 1.0f);
        CHECK(load.words().starts_with("large.obj: "));
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const double whole = process_ms() - start;
    CHECK(most > 0.2f);
    start = process_ms();
    {
        BackgroundLoad other;
        other.start(file);
        other.cancel();
        CHECK_FALSE(other.busy());
        CHECK_FALSE(other.poll());
    }  // waits for the thread
    const double cancelled = process_ms() - start;
    fmt::print("loading took {:.0f} ms of processor time, cancelled {:.0f}\n", whole, cancelled);
    CHECK(cancelled < 0.7 * whole);
}

TEST_CASE("what another process reads is given up at once when it is cancelled, and that process ends") {
    Progress progress_here;
    lightwalk::progress() = &progress_here;
    std::thread cancels([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        progress_here.cancelled = true;
    });
    const double start = now_ms();
    CHECK_THROWS_AS(run_guarded("slow.gltf", "a reader", {},
                                [] {
                                    std::this_thread::sleep_for(std::chrono::seconds(20));
                                    return std::string("read");
                                }),
                    Cancelled);
    CHECK(now_ms() - start < 10000);
    cancels.join();
    lightwalk::progress() = nullptr;
    CHECK(run_guarded("fast.gltf", "a reader", {}, [] { return std::string("read"); }) == "read");
}

TEST_CASE("what comes to the device in slices is drawn as what is loaded at once, and nothing of it is loaded again") {
    const FileFolder folder;
    write_file(folder.path / "grid.obj", "mtllib grid.mtl\nusemtl wall\n" + grid_text(300));
    write_file(folder.path / "grid.mtl", "newmtl wall\nmap_Kd wall.png\nnorm bumps.png\nmap_Ks gone.png\n");
    Image8 wall{67, 33}, bumps{1024, 1536};  // its first level is more than a slice
    for (int y = 0; y < wall.height; ++y)
        for (int x = 0; x < wall.width; ++x) wall.at(x, y) = {uint8_t(3 * x), uint8_t(7 * y), 90, 255};
    for (int y = 0; y < bumps.height; ++y)
        for (int x = 0; x < bumps.width; ++x) bumps.at(x, y) = {uint8_t(100 + x % 50), uint8_t(90 + y % 60), 230, 255};
    write_png(folder.path / "wall.png", wall);
    write_png(folder.path / "bumps.png", bumps);
    const auto file = folder.path / "grid.obj";
    BackgroundLoad load;
    load.start(file);
    BackgroundLoad::Ended ended = waited_for(load);
    REQUIRE(ended.model);
    CHECK(ended.model->textures.size() == 2);  // the third is not there

    Gpu& gpu = check_device();
    Arrival arrival(gpu, file, std::move(*ended.model));
    int slices = 1;
    while (!arrival.step(0)) {
        CHECK(arrival.share() < 1.0f);
        ++slices;
    }
    CHECK(slices > 10);
    CHECK(arrival.share() == 1.0f);
    const auto prepared = [&](Scene& scene, Maps& maps) {
        scene.load(gpu, scene_of_model(file, {}), [](const auto& path) { return load_model(path); });
        maps.prepare(gpu, scene);
    };
    struct : Module {
    } owner;
    Maps maps(owner, "maps"), other_maps(owner, "other");
    Scene scene, other;
    arrival.give(scene);
    const uint64_t before = gpu.uploaded_bytes;
    prepared(scene, maps);
    CHECK(gpu.uploaded_bytes - before < 10000);  // instances and materials
    prepared(other, other_maps);
    REQUIRE(scene.items.size() == 1);
    const DrawItem &ours = scene.items[0], &theirs = other.items.at(0);
    for (const char* attribute : {"tangents"})
        CHECK(gpu.read_back(ours.model->attributes[attribute][0]) ==
              gpu.read_back(theirs.model->attributes[attribute][0]));
    CHECK(gpu.read_back(ours.model->vertices[0]) == gpu.read_back(theirs.model->vertices[0]));
    CHECK(gpu.read_back(ours.model->indices[0]) == gpu.read_back(theirs.model->indices[0]));
    const auto check_alike = [&](const Image& image, const Image& other_image) {
        REQUIRE(image.desc == other_image.desc);
        for (uint32_t m = 0; m < image.desc.mips; ++m)
            CHECK(gpu.read_back(ImageView(image).mip(m)) == gpu.read_back(ImageView(other_image).mip(m)));
    };
    for (const MapSlot slot : {MapSlot::diffuse, MapSlot::normal}) {
        REQUIRE(ours.maps[slot]);
        check_alike(*ours.maps[slot], *theirs.maps[slot]);
    }
    // As data it is halved by the device, some rows at a time.
    const auto data = [&](Scene& of) { return of.images(gpu).load(folder.path / "bumps.png", TextureKind::data); };
    check_alike(*data(scene), *data(other));
}

TEST_CASE("what is previewed after another file is the picture that it is alone") {
    Gpu& gpu = check_device();
    Preview preview;
    std::vector<Image8> pictures;
    for (const char* file : {"models/cube.obj", "models/sphere.obj", "models/cube.obj"}) {
        const auto path = find_asset(file);
        const SceneFile scene = scene_of_model(path, model_bounds(load_model(path)));
        pictures.push_back(preview.draw(gpu, scene, Thumbnails::size));
        CHECK(pictures.back().pixels == Preview().draw(gpu, scene, Thumbnails::size).pixels);
    }
    CHECK(pictures[0].pixels == pictures[2].pixels);
    CHECK(pictures[0].pixels != pictures[1].pixels);
}

TEST_CASE("a thumbnail's file depends on the path, the size and the time of its file") {
    const FileFolder folder;
    write_file(folder.path / "a.obj", grid_text(1));
    write_file(folder.path / "b.obj", grid_text(1));
    const auto first = thumbnail_file(folder.path / "a.obj");
    CHECK(first.extension() == ".png");
    CHECK(first == thumbnail_file(folder.path / "a.obj"));
    CHECK(first != thumbnail_file(folder.path / "b.obj"));
    write_file(folder.path / "a.obj", grid_text(2));
    CHECK(first != thumbnail_file(folder.path / "a.obj"));
}

TEST_CASE("the material ball has the object's numbers and the textures of its model") {
    DrawItem item;
    item.model = std::make_shared<GpuModel>();
    item.model->model.materials.resize(1);
    item.model->model.materials[0].diffuse_map.file = "wood.png";
    item.model->model.meshes.push_back({.parts = {{0, 3, 0}}});
    item.material.diffuse = {0.1f, 0.2f, 0.3f};
    item.loaded_maps[MapSlot::diffuse] = std::make_shared<Image>();
    SceneObject object;
    object.material.roughness = 0.25f;
    object.material.maps["normal"] = "own_normal.png";
    const SceneFile scene = material_ball(object, item);
    const MaterialOverride& material = scene.objects.at(0).material;
    CHECK(material.diffuse == glm::vec3(0.1f, 0.2f, 0.3f));
    CHECK(material.roughness == 0.25f);
    CHECK(material.maps.at("diffuse") == "wood.png");
    CHECK(material.maps.at("normal") == "own_normal.png");
    object.material.maps["diffuse"] = "own.png";
    CHECK(material_ball(object, item).objects.at(0).material.maps.at("diffuse") == "own.png");
}

TEST_CASE("a picture's thumbnail is the middle of it, and all of its height") {
    const FileFolder folder;
    Image8 wide(480, 100);  // 160 pixels of it have a thumbnail's shape: the middle third
    for (int y = 0; y < wide.height; ++y)
        for (int x = 0; x < wide.width; ++x)
            wide.at(x, y) = x < 160   ? glm::u8vec4(255, 0, 0, 255)
                            : x < 320 ? glm::u8vec4(0, 255, 0, 255)
                                      : glm::u8vec4(0, 0, 255, 255);
    write_png(folder.path / "wide.png", wide);
    Thumbnails thumbnails;
    Preview preview;
    CHECK(thumbnails.of(folder.path / "wide.png") == nullptr);
    CHECK(thumbnails.carry_on(check_device(), preview));
    const Image8* seen = thumbnails.of(folder.path / "wide.png");
    REQUIRE(seen);
    const auto size = glm::ivec2(Thumbnails::size);
    for (const glm::ivec2 at : {glm::ivec2(0), glm::ivec2(size.x - 1, 0), glm::ivec2(0, size.y - 1), size / 2})
        CHECK(seen->at(at.x, at.y) == glm::u8vec4(0, 255, 0, 255));
}
