// The nearest blocker: shadow rays themselves end at the first one that they find.
#include "render/blocker.h"

#include "render/transmittance.h"
#include "shading/material.h"

namespace {

/// Keeps the nearest opaque crossing.
class OpaqueCrossing : public CrossingVisitor {
 public:
  explicit OpaqueCrossing(const ShadowQuery& way) : way_(way) {}

  void visit(const Crossing& crossing) override {
    const double nearest = found_ ? found_->t : way_.tmax;
    if (!(crossing.t > way_.tmin && crossing.t < nearest)) return;
    const Vec3d point = way_.ray.pointAtParameter(crossing.t);
    if (anyPositive(transparencyAt(*crossing.material, point))) return;
    found_ = Blocker{crossing.object, std::nullopt, crossing.t};
  }
  const std::optional<Blocker>& found() const { return found_; }

 private:
  const ShadowQuery& way_;
  std::optional<Blocker> found_;
};

}  // namespace

std::optional<Blocker> findBlocker(const Object3D& geometry, const ShadowQuery& way,
                                   bool transparentShadows) {
  if (transparentShadows) {
    OpaqueCrossing visitor(way);
    geometry.visitCrossings(way.ray, visitor);
    return visitor.found();
  }
  Hit hit(way.tmax);
  if (!geometry.intersect(way.ray, hit, way.tmin)) return std::nullopt;
  return Blocker{hit.getObject(), hit.getFace(), hit.getT()};
}
