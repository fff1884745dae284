// The same rays through Intel's Embree, which is written by others and used by many.
#include "05_shadow_maps/ray_fixture.h"
#include "catch.h"

#ifdef LIGHTWALK_EMBREE
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

using namespace lightwalk;

namespace {

class EmbreeScene {
  public:
    explicit EmbreeScene(const std::vector<RayTriangle>& triangles) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);  // Woop's test, too
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* corners = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), 3 * triangles.size()));
        auto* indices = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), triangles.size()));
        for (const RayTriangle& t : triangles)
            for (const glm::vec3& p : {t.a, t.b, t.c}) *corners++ = p;
        for (uint32_t i = 0; i < 3 * triangles.size(); ++i) indices[i] = i;
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    ~EmbreeScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeScene(const EmbreeScene&) = delete;

    /// t of the nearest hit; ray.most where there is none.
    float closest(const TestRay& ray) const {
        RTCRayHit rayhit{};
        rayhit.ray = {.org_x = ray.origin.x,
                      .org_y = ray.origin.y,
                      .org_z = ray.origin.z,
                      .tnear = ray.least,
                      .dir_x = ray.direction.x,
                      .dir_y = ray.direction.y,
                      .dir_z = ray.direction.z,
                      .time = 0,
                      .tfar = ray.most,
                      .mask = ~0u,
                      .id = 0,
                      .flags = 0};
        rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect1(scene_, &rayhit);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &rayhit);
#endif
        return rayhit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? ray.most : rayhit.ray.tfar;
    }

  private:
    RTCDevice device_ = rtcNewDevice(nullptr);
    RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace

TEST_CASE("rays hit what Embree's hit") {
    for (const char* model : {"models/teapot.obj", "models/suzanne.obj", "models/car.obj", "models/bunny.obj"}) {
        const auto triangles = triangles_of(model);
        const EmbreeScene embree(triangles);
        const auto rays = random_rays(bounds_of(triangles), 50000, 3);
        const auto hits = trace(check_device(), Bvh(triangles), rays);
        size_t apart = 0, found = 0;
        double largest = 0;
        for (size_t i = 0; i < rays.size(); ++i) {
            const float theirs = embree.closest(rays[i]);
            const bool hit = theirs < rays[i].most;
            const double difference = hit ? std::fabs(double(hits[i].t) - double(theirs)) / double(theirs) : 0;
            if (hit != (hits[i].found == 1) || difference > 1e-3)
                ++apart;
            else
                largest = std::max(largest, difference);
            found += hit;
        }
        WARN(model << ": of " << rays.size() << " rays " << found << " hit; " << apart
                   << " differ; the others' distances by " << largest << " at most");
        CHECK(found > rays.size() / 5);
        CHECK(apart <= rays.size() / 10000);  // those through an edge seen from the side
    }
}
#else
TEST_CASE("rays hit what Embree's hit") { WARN("left out: it takes Debian's libembree-dev"); }
#endif
