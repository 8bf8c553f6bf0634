// Meshes far from 0, such as those in the coordinates of a country's survey.
//
// Between floats near 5,000,000 lies a half: what is small there becomes terraces. So the vertices
// of such a mesh are read in double, and kept as floats measured from an origin of its own.
//
// The origin is the middle of the box of the faces, rounded to a multiple of a power of two that is
// about the box's size and a unit in the last place of every coordinate or more. Then the origin
// and an offset, rounded to float, add up to a double exactly. For the difference of a place and
// the origin is a multiple of the place's last unit: either float holds it, and the sum is the
// place; or its last unit in float is a larger one, of which the sum is a multiple too, and not
// 2^53 of them.
#include <algorithm>
#include <cmath>

#include "math/bounding_box.h"
#include "scene/number_reader.h"
#include "scene/obj_reader.h"
#include "scene/obj_words.h"

namespace {

bool isFar(const BoundingBox& box) {
  constexpr double kFarSizes = 16;
  const Vec3d nearest = largest(largest(box.low(), -box.high()), Vec3d());
  return maxAbs(nearest) > kFarSizes * box.longestSide();
}

}  // namespace

/// A box that is not far does not become so by more faces.
bool isFarMesh(const std::vector<Vec3f>& vertices, const std::vector<MeshGeometry::Face>& faces) {
  BoundingBox box;
  for (const MeshGeometry::Face& face : faces) {
    for (const std::uint32_t vertex : face) box.extend(vertices[vertex]);
    if (!isFar(box)) return false;
  }
  return !faces.empty();
}

void readObjPlaces(std::string_view statements, std::vector<Vec3d>& places) {
  const ObjWords words(statements.data() + statements.size());
  words.forEachStatement(statements.data(), [&](const char* p) {
    if (!words.isStatement('v', p)) return p;
    Vec3d& place = places.emplace_back();
    ++p;
    for (int axis = 0; axis < 3; ++axis) {
      const char* const stop = scanNumber(words.findWord(p), words.end(), place[axis]);
      if (stop) p = stop;
    }
    return p;
  });
}

Vec3d measureFromMiddle(const std::vector<Vec3d>& places,
                        const std::vector<MeshGeometry::Face>& faces,
                        std::vector<Vec3f>& vertices) {
  BoundingBox box;
  for (const MeshGeometry::Face& face : faces) {
    for (const std::uint32_t vertex : face) box.extend(places[vertex]);
  }
  const double size = std::max({box.longestSide(), box.extent() * 0x1p-50, 0x1p-1000});
  const double unit = std::ldexp(1, std::ilogb(size));
  Vec3d origin;
  for (int axis = 0; axis < 3; ++axis) {
    origin[axis] = std::floor((box.low()[axis] + box.high()[axis]) / (2 * unit) + 0.5) * unit;
  }
  const auto offset = [](double place, double from) {  // a vertex of no face may be anywhere
    constexpr double kMost = std::numeric_limits<float>::max();
    return float(std::clamp(place - from, -kMost, kMost));
  };
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      vertices[k][axis] = offset(places[k][axis], origin[axis]);
    }
  }
  return origin;
}
