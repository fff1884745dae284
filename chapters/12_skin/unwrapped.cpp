#include <cmath>
#include <numeric>
#include <set>

#include "12_skin/skin.h"
#include "common/base/exercise.h"

namespace lightwalk {

std::vector<uint32_t> charts_of(const Mesh& mesh) {
    std::vector<uint32_t> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        for (const size_t corner : {i + 1, i + 2}) parent[root(mesh.indices[corner])] = root(mesh.indices[i]);
    std::vector<uint32_t> charts(parent.size(), UINT32_MAX);
    uint32_t count = 0;
    for (uint32_t i = 0; i < parent.size(); ++i) {
        uint32_t& number = charts[root(i)];
        if (number == UINT32_MAX) number = count++;
    }
    for (uint32_t i = 0; i < parent.size(); ++i) charts[i] = charts[root(i)];
    return charts;
}

double mm_per_uv(const DrawItem& item) {
    const Mesh& mesh = item.model->model.meshes[item.mesh];
    const Part& part = mesh.parts[item.part];
    double area = 0, of_map = 0;
    for (size_t i = part.first_index; i + 2 < part.first_index + part.index_count; i += 3) {
        glm::dvec3 p[3], t[3];
        for (size_t k = 0; k < 3; ++k) {
            const Vertex& vertex = mesh.vertices[mesh.indices[i + k]];
            p[k] = glm::dvec3(item.transform * glm::vec4(vertex.position, 1.0f));
            t[k] = glm::dvec3(vertex.uv, 0);
        }
        area += glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
        of_map += glm::length(glm::cross(t[1] - t[0], t[2] - t[0]));
    }
    return of_map > 0 ? 1000 * std::sqrt(area / of_map) : 0;
}

void add_charts(Gpu& gpu, const Scene& scene) {
    std::set<GpuModel*> done;
    for (const DrawItem& item : scene.items) {
        if (!done.insert(item.model.get()).second) continue;
        std::vector<Buffer> buffers;
        for (const Mesh& mesh : item.model->model.meshes)
            buffers.push_back(gpu.upload(mesh.name + " charts", charts_of(mesh)));
        item.model->attributes["charts"] = std::move(buffers);
    }
}

bool Unwrapped::record(Frame& frame, const Scene& scene, const Maps& maps, const DrawItem& item, uint32_t size) {
    if (made_.is_current(&item, scene.epoch, size, maps.epoch())) return false;
    const auto image = [&](Image& made, const char* name, VkFormat format) {
        made.ensure(frame.gpu.device,
                    {.name = std::string("skin ") + name, .format = format, .size = glm::uvec2(size), .kept = true});
    };
    constexpr VkFormat half4 = VK_FORMAT_R16G16B16A16_SFLOAT, float4 = VK_FORMAT_R32G32B32A32_SFLOAT;
    image(raw_position_, "raw position", float4);
    image(position, "position", float4);
    image(raw_normal_, "raw normal", half4);
    image(normal, "normal", half4);
    image(raw_albedo_, "raw albedo", half4);
    image(albedo, "albedo", half4);
    image(stretch, "stretch", half4);
    image(raw_stretch_, "raw stretch", half4);
    frame.raster("unwrap",
                 {.color = {clear(raw_position_, glm::vec4(0)), clear(raw_normal_, glm::vec4(0)),
                            clear(raw_albedo_, glm::vec4(0))},
                  .with = {maps}},
                 [&](Raster& pass) {
                     pass.use(unwrap_, maps.variant(item));
                     const auto is_it = [&](const DrawItem& other) { return &other == &item; };
                     pass.draw(scene.all().where(is_it));
                 });
    frame.compute("stretch", {.reads = {raw_position_, raw_normal_}, .writes = {raw_stretch_}}, [&](Compute& pass) {
        // More texels to a mm than this are none: where the layout pinches a surface, a blur would have no end.
        const float most_texels = static_cast<float>(size) / 64.0f;
        pass.use(stretch_).set("skin_position", raw_position_, nearest_clamp);
        pass.set("skin_normal", raw_normal_, nearest_clamp).set("most_texels", most_texels);
        pass.set("result", raw_stretch_).dispatch_threads(glm::uvec2(size));
    });
    frame.compute("grow charts",
                  {.reads = {raw_position_, raw_normal_, raw_albedo_, raw_stretch_},
                   .writes = {position, normal, albedo, stretch}},
                  [&](Compute& pass) {
                      pass.use(dilate_).set("position", raw_position_).set("normal", raw_normal_);
                      pass.set("albedo", raw_albedo_).set("stretch", raw_stretch_).set("wide_stretch", stretch);
                      pass.set("wide_position", position).set("wide_normal", normal).set("wide_albedo", albedo);
                      pass.dispatch_threads(glm::uvec2(size));
                  });
    return true;
}

void Unwrapped::trace_sky(Frame& frame, const SceneRays& rays, uint32_t rays_per_texel) {
    for (Image* image : {&noisy_, &occlusion})
        image->ensure(frame.gpu.device, {.name = "skin occlusion", .size = position.desc.size, .kept = true});
    frame.compute("occlusion", {.reads = {position, normal}, .writes = {noisy_}, .with = {rays}}, [&](Compute& pass) {
        pass.use(occlusion_).set("skin_position", position, nearest_clamp).set("skin_normal", normal, nearest_clamp);
        pass.set("occlusion_rays", rays_per_texel).set("result", noisy_).dispatch_threads(position.desc.size);
    });
    frame.compute("smooth occlusion", {.reads = {noisy_}, .writes = {occlusion}}, [&](Compute& pass) {
        pass.use(smooth_).set("from", noisy_, nearest_clamp).set("into", occlusion);
        pass.dispatch_threads(position.desc.size);
    });
}

}  // namespace lightwalk
