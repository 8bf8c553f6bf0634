// CubeMap: which face of the cube a direction meets, and where.
//
// On the face of component a, the direction's two others, divided by a, go from -1 to 1 across the
// face, and (b / a + 1) / 2 from 0 to 1. With a below 0 the quotient turns both axes around; how
// each face lies is fixed by the course's pictures, for whom y is up.
#include "shading/background.h"

Vec3d CubeMap::colorAt(const Vec3d& direction) const {
  const double x = direction.x(), y = direction.y(), z = direction.z();
  const auto look = [&](int face, double u, double v) {
    return pictures_[std::size_t(face)]->colorAt(u, v);
  };
  const auto across = [](double b, double a) { return (b / a + 1) / 2; };
  const int longest = longestAxis(direction);
  if (longest == 0) {
    const double u = across(z, x), v = across(y, x);
    return x > 0 ? look(1, u, v) : look(0, u, 1 - v);
  }
  if (longest == 1) {
    const double u = across(x, y), v = across(z, y);
    return y > 0 ? look(2, u, v) : look(3, 1 - u, 1 - v);
  }
  const double u = across(x, z), v = across(y, z);
  return z > 0 ? look(4, 1 - u, v) : look(5, u, 1 - v);
}
