// embree_tracer MESH.obj OUTPUT.tga SIDE: the rival as a whole program, for the benchmark's scene.
// Prints the seconds that it took to read, build, trace and write.
#include <embree3/rtcore.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <thread>
#include <vector>

#include "rivals/plain_obj.h"
#include "rivals/plain_shading.h"

namespace bench {
namespace {

using Bytes = std::vector<unsigned char>;
constexpr int kTile = 16;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

RTCGeometry readMesh(RTCDevice device, const std::string& path) {
  const PlainObj obj(path);
  const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* const coordinates = static_cast<float*>(rtcSetNewGeometryBuffer(
      mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), obj.vertexCount()));
  auto* const indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), obj.faceCount()));
  obj.read(coordinates, indices);
  rtcCommitGeometry(mesh);
  return mesh;
}

class Picture {
 public:
  explicit Picture(int side) : side_(side), bytes_(18 + 3 * std::size_t(side) * std::size_t(side)) {
    bytes_[2] = 2;
    bytes_[12] = bytes_[14] = static_cast<unsigned char>(side & 255);
    bytes_[13] = bytes_[15] = static_cast<unsigned char>(side >> 8);
    bytes_[16] = 24;
    bytes_[17] = 0x20;
  }
  void set(int i, int j, const Vec3f& color) {
    const std::size_t row = std::size_t(side_ - 1 - j);
    unsigned char* const p = &bytes_[18 + 3 * (row * std::size_t(side_) + std::size_t(i))];
    for (int k = 0; k < 3; ++k) {
      p[k] = static_cast<unsigned char>(std::fmin(255.0f, std::fmax(0.0f, color[2 - k] * 255)));
    }
  }
  void write(const char* path) const {
    std::FILE* const file = std::fopen(path, "wb");
    if (!file) throw std::runtime_error("the picture cannot be written");
    const bool isWhole = std::fwrite(bytes_.data(), 1, bytes_.size(), file) == bytes_.size();
    if (std::fclose(file) != 0 || !isWhole) throw std::runtime_error("the picture is cut off");
  }
  int side() const { return side_; }

 private:
  int side_;
  Bytes bytes_;
};

void renderTile(const PlainTracer& tracer, int tile, Picture& picture) {
  const int side = picture.side(), perRow = (side + kTile - 1) / kTile;
  const Vec3f d = normalize(kView), right = normalize(cross(d, Vec3f(0, 1, 0)));
  const Vec3f up = cross(right, d);
  const float spread = 2 * std::tan(kViewAngle * 3.14159265f / 360);
  const int left = tile % perRow * kTile, bottom = tile / perRow * kTile;
  for (int j = bottom; j < std::min(bottom + kTile, side); ++j) {
    for (int i = left; i < std::min(left + kTile, side); ++i) {
      const float x = (float(i) + 0.5f) / float(side) - 0.5f;
      const float y = (float(j) + 0.5f) / float(side) - 0.5f;
      const Vec3f direction = normalize(d + spread * (x * right + y * up));
      picture.set(i, j, tracer.trace(kEye, direction, 0, 0, 1));
    }
  }
}

void renderAll(const PlainTracer& tracer, Picture& picture) {
  const int perRow = (picture.side() + kTile - 1) / kTile;
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int tile; (tile = next++) < perRow * perRow;) renderTile(tracer, tile, picture);
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
}

void run(const char* mesh, const char* output, int side) {
  const double start = now();
  const RTCDevice device = rtcNewDevice(nullptr);
  const RTCScene scene = rtcNewScene(device);
  rtcAttachGeometry(scene, readMesh(device, mesh));
  const double read = now();
  rtcCommitScene(scene);
  const double built = now();
  Picture picture(side);
  renderAll(PlainTracer(scene), picture);
  const double traced = now();
  picture.write(output);
  std::printf("%.6f %.6f %.6f %.6f\n", read - start, built - read, traced - built, now() - traced);
}

}  // namespace
}  // namespace bench

int main(int count, char** words) {
  if (count != 4) return 2;
  try {
    bench::run(words[1], words[2], std::atoi(words[3]));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "embree_tracer: %s\n", error.what());
    return 1;
  }
}
