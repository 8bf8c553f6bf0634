// EmbreeScene on Embree 3: one triangle mesh, shared buffers, default build quality (medium).
#include "rivals/embree_scene.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <cstring>
#include <stdexcept>
#include <string>

namespace bench {
namespace {

struct Memory {
  std::atomic<std::ptrdiff_t> now{0}, most{0};
};

/// Called by the device before it takes (bytes > 0) or after it gives back memory.
bool noteMemory(void* memory, ssize_t bytes, bool) {
  auto& counts = *static_cast<Memory*>(memory);
  const std::ptrdiff_t now = counts.now += bytes;
  std::ptrdiff_t most = counts.most;
  while (now > most && !counts.most.compare_exchange_weak(most, now)) {
  }
  return true;
}

void attach(RTCDevice device, RTCScene scene, const Vec3f* vertices, std::size_t vertexCount,
            const MeshGeometry::Face* faces, std::size_t faceCount) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices, 0,
                             sizeof(Vec3f), vertexCount);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, faces, 0,
                             sizeof(MeshGeometry::Face), faceCount);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

RTCIntersectContext contextOf(bool isCoherent) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags =
      isCoherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  return context;
}

RTCRay rayOf(const FloatRay& r) {
  RTCRay ray;
  ray.org_x = r.origin[0];
  ray.org_y = r.origin[1];
  ray.org_z = r.origin[2];
  ray.tnear = r.tmin;
  ray.dir_x = r.direction[0];
  ray.dir_y = r.direction[1];
  ray.dir_z = r.direction[2];
  ray.tfar = r.tmax;
  ray.time = 0;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
  return ray;
}

void fill(RTCRay16& rays, const FloatPacket& packet) {
  std::memcpy(rays.org_x, packet.origin[0], sizeof rays.org_x);
  std::memcpy(rays.org_y, packet.origin[1], sizeof rays.org_y);
  std::memcpy(rays.org_z, packet.origin[2], sizeof rays.org_z);
  std::memcpy(rays.tnear, packet.tmin, sizeof rays.tnear);
  std::memcpy(rays.dir_x, packet.direction[0], sizeof rays.dir_x);
  std::memcpy(rays.dir_y, packet.direction[1], sizeof rays.dir_y);
  std::memcpy(rays.dir_z, packet.direction[2], sizeof rays.dir_z);
  std::memcpy(rays.tfar, packet.tmax, sizeof rays.tfar);
}

/// What no ray of ours uses.
void clearRest(RTCRay16& rays) {
  std::memset(rays.time, 0, sizeof rays.time);
  std::memset(rays.mask, 0xFF, sizeof rays.mask);
  std::memset(rays.id, 0, sizeof rays.id);
  std::memset(rays.flags, 0, sizeof rays.flags);
}

struct alignas(64) ValidLanes {
  explicit ValidLanes(int count) {
    for (int lane = 0; lane < 16; ++lane) flags[lane] = lane < count ? -1 : 0;
  }
  int flags[16];
};

}  // namespace

struct EmbreeScene::Content {
  const MeshGeometry& mesh;
  Memory memory;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  bool isRobust = false;

  RTCScene newScene() const {
    const RTCScene made = rtcNewScene(device);
    rtcSetSceneBuildQuality(made, RTC_BUILD_QUALITY_MEDIUM);
    if (isRobust) rtcSetSceneFlags(made, RTC_SCENE_FLAG_ROBUST);
    return made;
  }

  /// Threads and lazy tables of the device come into being with a first small scene.
  void warmUp() const {
    const RTCScene small = newScene();
    attach(device, small, mesh.getVertices().data(), mesh.getVertices().size(),
           mesh.getFaces().data(), std::min<std::size_t>(mesh.getFaces().size(), 20000));
    rtcCommitScene(small);
    rtcReleaseScene(small);
  }
};

bool EmbreeScene::isAvailable() { return true; }

EmbreeScene::EmbreeScene(const MeshGeometry& mesh, int threads, bool isRobust)
    : content_(new Content{mesh, {}, nullptr, nullptr, isRobust}) {
  content_->device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
  if (!content_->device) throw std::runtime_error("Embree: no device");
  content_->warmUp();
  rtcSetDeviceMemoryMonitorFunction(content_->device, noteMemory, &content_->memory);
}

EmbreeScene::~EmbreeScene() {
  if (content_->scene) rtcReleaseScene(content_->scene);
  rtcReleaseDevice(content_->device);
}

void EmbreeScene::build() {
  const MeshGeometry& mesh = content_->mesh;
  content_->scene = content_->newScene();
  attach(content_->device, content_->scene, mesh.getVertices().data(), mesh.getVertices().size(),
         mesh.getFaces().data(), mesh.getFaces().size());
  rtcCommitScene(content_->scene);
}

std::size_t EmbreeScene::keptBytes() const { return std::size_t(content_->memory.now); }
std::size_t EmbreeScene::peakBytes() const { return std::size_t(content_->memory.most); }

std::size_t EmbreeScene::traceSingle(const RaySet& set, std::size_t first, std::size_t end,
                                     bool anyHit, bool isCoherent) const {
  RTCIntersectContext context = contextOf(isCoherent);
  std::size_t hits = 0;
  for (std::size_t i = set.firstRay[first]; i < set.firstRay[end]; ++i) {
    if (anyHit) {
      RTCRay ray = rayOf(set.floatRays[i]);
      rtcOccluded1(content_->scene, &context, &ray);
      hits += ray.tfar < 0;
    } else {
      RTCRayHit ray;
      ray.ray = rayOf(set.floatRays[i]);
      ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(content_->scene, &context, &ray);
      hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
  }
  return hits;
}

std::size_t EmbreeScene::tracePackets(const RaySet& set, std::size_t first, std::size_t end,
                                      bool anyHit, bool isCoherent) const {
  RTCIntersectContext context = contextOf(isCoherent);
  std::size_t hits = 0;
  RTCRayHit16 rays;
  clearRest(rays.ray);
  for (std::size_t i = set.firstPacket[first]; i < set.firstPacket[end]; ++i) {
    const FloatPacket& packet = set.packets[i];
    const ValidLanes valid(packet.count);
    fill(rays.ray, packet);
    if (anyHit) {
      rtcOccluded16(valid.flags, content_->scene, &context, &rays.ray);
      for (int lane = 0; lane < packet.count; ++lane) hits += rays.ray.tfar[lane] < 0;
    } else {
      std::memset(rays.hit.geomID, 0xFF, sizeof rays.hit.geomID);
      std::memset(rays.hit.instID, 0xFF, sizeof rays.hit.instID);
      rtcIntersect16(valid.flags, content_->scene, &context, &rays);
      for (int lane = 0; lane < packet.count; ++lane) {
        hits += rays.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
      }
    }
  }
  return hits;
}

}  // namespace bench
