// CubeMap: which face of the cube a direction meets, and where.
//
// On the face of component a, the direction's two others, divided by a, go from -1 to 1 across the
// face, and (b / a + 1) / 2 from 0 to 1. With a below 0 the quotient turns both axes around; how
// each face lies is fixed by the course's pictures, for whom y is up.
#include "shading/background.h"

Vec3d CubeMap::colorAt(const Vec3d& direction) const {
  const int axis = longestAxis(direction);
  const bool isPositive = direction[axis] > 0;
  const auto across = [&](int other) { return (direction[other] / direction[axis] + 1) / 2; };
  const double u = across(axis == 0 ? 2 : 0), v = across(axis == 1 ? 2 : 1);
  constexpr std::size_t kFaceOf[3][2] = {{0, 1}, {3, 2}, {5, 4}};  // below 0, and above
  const std::size_t face = kFaceOf[axis][isPositive];
  const bool isTurned = face == 3 || face == 4;
  return pictures_[face]->colorAt(isTurned ? 1 - u : u, isPositive ? v : 1 - v);
}
