// Checkerboard: the parity of a point's cell.
#include "shading/checkerboard.h"

#include "math/noise.h"

double Checkerboard::weightOfSecond(const Vec3d& p) const {
  int parity = 0;
  for (int axis = 0; axis < 3; ++axis) parity ^= math::floorBits(p[axis] / size_, 1);
  return parity;
}
