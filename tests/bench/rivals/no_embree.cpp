// EmbreeScene where Embree's headers were not found: never constructed.
#include "rivals/embree_scene.h"

namespace bench {

struct EmbreeScene::Content {};

bool EmbreeScene::isAvailable() { return false; }
EmbreeScene::EmbreeScene(const MeshGeometry&, int, bool) {}
EmbreeScene::~EmbreeScene() = default;
void EmbreeScene::build() {}
std::size_t EmbreeScene::keptBytes() const { return 0; }
std::size_t EmbreeScene::peakBytes() const { return 0; }
std::size_t EmbreeScene::traceSingle(const RaySet&, std::size_t, std::size_t, bool, bool) const {
  return 0;
}
std::size_t EmbreeScene::tracePackets(const RaySet&, std::size_t, std::size_t, bool, bool) const {
  return 0;
}

}  // namespace bench
