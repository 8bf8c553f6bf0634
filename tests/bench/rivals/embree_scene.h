// EmbreeScene: the rival, behind an interface that needs none of its headers.
#pragma once
#include <cstddef>
#include <memory>

#include "geometry/mesh_geometry.h"
#include "ray_set.h"

namespace bench {

class EmbreeScene {
 public:
  /// False where the benchmark was built without Embree; the constructor then must not be called.
  static bool isAvailable();

  /// Starts a device of `threads` threads and warms it up. `mesh` is not owned and not copied.
  /// `isRobust` asks for its watertight mode.
  EmbreeScene(const MeshGeometry& mesh, int threads, bool isRobust = false);
  ~EmbreeScene();

  /// Builds with medium quality. To be called once.
  void build();
  /// Bytes that the device holds now, and the most it ever held; vertices and indices not counted.
  std::size_t keptBytes() const;
  std::size_t peakBytes() const;

  /// Traces the rays of tiles `first` .. end - 1 one by one, or 16 at a time, for the nearest hit
  /// or for any, and returns how many hit. `isCoherent` says that the rays of a tile run alike.
  std::size_t traceSingle(const RaySet& set, std::size_t first, std::size_t end, bool anyHit,
                          bool isCoherent) const;
  std::size_t tracePackets(const RaySet& set, std::size_t first, std::size_t end, bool anyHit,
                           bool isCoherent) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace bench
