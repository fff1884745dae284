#include "18_playground/picker.h"

#include "18_playground/item_box.h"

namespace lightwalk {

Picker::Picker(Module& owner, std::string name) : Module(owner, std::move(name), "picker") {}

// [record]
void Picker::record(Frame& frame, const View& view, const Scene& scene, const Maps& maps) {
    if (method.is("ids")) return draw_ids(frame, scene, maps);
    trace(frame, view, scene, maps);
}

// An integer target is cleared to 0, and nothing blends or resolves it.
void Picker::draw_ids(Frame& frame, const Scene& scene, const Maps& maps) {
    frame.raster("pick", {.color = {clear(ids, glm::vec4(0.0f))}, .depth = clear(depth_, 0.0f), .with = {maps}},
                 [&](Raster& pass) {
                     maps.draw(pass, scene, scene.opaque(), id_.loaded, id_.displaced);
                     maps.draw(pass, scene, scene.transparent(), glass_.loaded, glass_.displaced);
                 });
}
// [/record]

void Picker::trace(Frame& frame, const View& view, const Scene& scene, const Maps& maps) {
    const bool by_box = method.is("boxes");
    if (!by_box) {
        rays.through_holes = method.is("rays_cut");
        rays.record(frame, scene, &maps);
    }
    if (placed_ != scene.epoch) {
        placed_ = scene.epoch;
        std::vector<ItemBox> boxes;
        for (const DrawItem& one : scene.items) boxes.push_back({one.bounds.lower, one.bounds.upper});
        if (boxes.empty()) boxes.push_back({glm::vec3(1.0f), glm::vec3(-1.0f)});
        frame.upload("pick boxes", item_boxes_, boxes);
    }
    if (!by_box) {
        std::vector<uint32_t> in_order, of_triangle;
        for (uint32_t i = 0; i < scene.items.size(); ++i)
            if (const DrawItem& one = scene.items[i]; !one.transparent)
                in_order.insert(in_order.end(), one.model->model.meshes[one.mesh].parts[one.part].index_count / 3, i);
        for (const uint32_t place : rays.bvh().order())
            of_triangle.push_back(place < in_order.size() ? in_order[place] : 0);
        if (of_triangle.empty()) of_triangle.push_back(0);
        frame.upload("pick triangles", triangle_items_, of_triangle);
    }
    const ViewRays through = view_rays(view);
    if (by_box) {
        frame.compute("pick", {.reads = {item_boxes_}, .writes = {ids}}, [&](Compute& pass) {
            pass.use(boxes_).set("boxes", item_boxes_).set("through", through);
            pass.set("count", static_cast<uint32_t>(scene.items.size()))
                .set("found_ids", ids)
                .dispatch_threads(frame.size);
        });
        return;
    }
    frame.compute("pick", {.reads = {triangle_items_}, .writes = {ids}, .with = {rays}}, [&](Compute& pass) {
        pass.use(trace_).set("triangle_items", triangle_items_).set("through", through);
        pass.set("found_ids", ids).dispatch_threads(frame.size);
    });
}

// [pick]
void Picker::pick(Frame& frame, glm::ivec2 pixel) {
    if (!result_) result_ = Buffer(frame.gpu.device, {.name = path() + " result", .bytes = sizeof(uint32_t) * 2});
    frame.compute("picked", {.reads = {ids}, .writes = {result_}}, [&](Compute& pass) {
        pass.use(near_).set("ids", ids, nearest_clamp).set("result", result_);
        pass.set("asked", glm::ivec3(pixel, reach.value)).dispatch({1, 1, 1});
    });
    frame.read_back(result_, read_);
    asked_ = true;
}

bool Picker::poll() {
    if (!asked_ || !read_) return false;
    asked_ = false;
    const std::vector<uint32_t> answer = read_.as<uint32_t>();
    item.reset();
    if (answer.at(0) != 0) item = answer.at(1);
    return true;
}
// [/pick]

}  // namespace lightwalk
