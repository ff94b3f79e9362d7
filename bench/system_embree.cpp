/// Embree's point query, as its own tutorial uses it: a callback finds the closest point of one triangle and
/// shrinks the query's radius.
#include <embree3/rtcore.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>

#include "system.h"

namespace cdfr::bench {
namespace {

struct Vec3f {
  float x, y, z;
};
Vec3f operator-(Vec3f a, Vec3f b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3f operator+(Vec3f a, Vec3f b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec3f operator*(float s, Vec3f a) { return {s * a.x, s * a.y, s * a.z}; }
float dot(Vec3f a, Vec3f b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// Ericson, Real-Time Collision Detection, 5.1.5: the region of the point by signs of dot products.
Vec3f closest_point(Vec3f p, Vec3f a, Vec3f b, Vec3f c) {
  const Vec3f ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const float d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const float d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const float d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const float scale = 1 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

/// Where the callback finds the triangles: the buffers that Embree holds.
struct Triangles {
  const Vec3f* vertices = nullptr;
  const Triangle* indices = nullptr;
};

bool shrink_to_triangle(RTCPointQueryFunctionArguments* arguments) {
  const auto& triangles = *static_cast<const Triangles*>(arguments->userPtr);
  const Triangle& t = triangles.indices[arguments->primID];
  RTCPointQuery& query = *arguments->query;
  const Vec3f p{query.x, query.y, query.z};
  const Vec3f to =
      closest_point(p, triangles.vertices[t[0]], triangles.vertices[t[1]], triangles.vertices[t[2]]) - p;
  const float square = dot(to, to);
  if (!(square < query.radius * query.radius)) return false;
  query.radius = std::sqrt(square);
  return true;
}

std::atomic<std::int64_t> bytes_held{0};

bool count_bytes(void*, ssize_t bytes, bool) {
  bytes_held += bytes;
  return true;
}

/// One for the program: starting it is not part of a build.
RTCDevice device() {
  static const RTCDevice made = [] {
    // With a number of threads, Embree would hold all of the program to it.
    const RTCDevice fresh = rtcNewDevice(nullptr);
    rtcSetDeviceMemoryMonitorFunction(fresh, count_bytes, nullptr);
    return fresh;
  }();
  return made;
}

class EmbreeSystem final : public System {
 public:
  explicit EmbreeSystem(const Mesh& mesh) : scene_(rtcNewScene(device())) {
    const std::int64_t held_before = bytes_held;
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<Vec3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.vertices.size()));
    std::transform(mesh.vertices.begin(), mesh.vertices.end(), vertices, [](Vec3 v) {
      return Vec3f{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    });
    auto* indices = static_cast<Triangle*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), mesh.triangles.size()));
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), indices);
    triangles_ = {vertices, indices};
    rtcSetGeometryPointQueryFunction(geometry, shrink_to_triangle);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    tbb::task_arena one(1);
    one.execute([this] { rtcCommitScene(scene_); });
    bytes_ = static_cast<std::size_t>(bytes_held - held_before);
  }
  EmbreeSystem(const EmbreeSystem&) = delete;
  EmbreeSystem& operator=(const EmbreeSystem&) = delete;
  ~EmbreeSystem() override { rtcReleaseScene(scene_); }

  std::size_t bytes() const override { return bytes_; }
  void singles(std::span<const Vec3> points, std::span<double> out) const override {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = distance(points[i]);
  }

 private:
  double distance(Vec3 p) const {
    RTCPointQuery query{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 0,
                        std::numeric_limits<float>::infinity()};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &query, &context, nullptr, const_cast<Triangles*>(&triangles_));
    return query.radius;
  }

  std::size_t bytes_ = 0;
  RTCScene scene_;
  Triangles triangles_;
};

}  // namespace

Result<std::unique_ptr<System>> build_embree(const Mesh& mesh, unsigned) {
  return {std::make_unique<EmbreeSystem>(mesh)};
}

}  // namespace cdfr::bench
