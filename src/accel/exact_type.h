// Exact types: a class derived from a known one may answer differently, so it counts as unknown.
#pragma once
#include <typeinfo>

#include "geometry/object3d.h"

namespace accel {

/// `object` (not null) as a T where it is a T itself and not of a class derived from T, else null.
template <class T>
const T* exactly(const Object3D* object) {
  return typeid(*object) == typeid(T) ? static_cast<const T*>(object) : nullptr;
}

}  // namespace accel
