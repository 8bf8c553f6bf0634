// Blocker: what stands in the way of a light.
#pragma once
#include <cstdint>
#include <optional>

#include "geometry/batch_geometry.h"
#include "geometry/object3d.h"

struct Blocker {
  const Object3D* object;             ///< not owned
  std::optional<std::uint32_t> part;  ///< of the object, where that is known
  double t;                           ///< along the shadow ray
};

/// The nearest surface at way.tmin < t < way.tmax that lets no light through, where there is one:
/// any surface, or with `transparentShadows` only one that is opaque where it is crossed.
std::optional<Blocker> findBlocker(const Object3D& geometry, const ShadowQuery& way,
                                   bool transparentShadows);
