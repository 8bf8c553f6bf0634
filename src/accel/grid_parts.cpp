// GridParts: walks the tree of objects, and bounds what rounding can do to a hit.
//
// The double functions that decide hits err by a few units in the last place of the largest number
// that they see: of the ray's origin, of the object, of the point. Under Transforms each space has
// numbers of its own; an error there, taken back to the world, is as much larger as the map
// stretches. The margin of an object is the sum over all its spaces, for 64 units where proofs need
// some 30, plus how far the rounded inverse of each Transform is from the inverse of its matrix,
// plus kSlack of the scene. The slack covers the walk through the cells, and rays that strike a
// triangle so flat that t loses digits: down to an angle of some 2^-34.
#include "accel/grid_parts.h"

#include <algorithm>
#include <cmath>

#include "accel/exact_type.h"
#include "geometry/group.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"

namespace accel {
namespace {

constexpr double kUnit = 0x1p-47;          // 64 rounding errors
constexpr double kSlack = 0x1p-14;         // of the scene's longest side
constexpr double kReach = 0x1p10;          // of the scene's longest side
constexpr double kLargestMargin = 0x1p-6;  // of the scene's longest side
constexpr double kLargest = 0x1p200, kSmallest = 0x1p-200;

/// The largest sum of absolute factors in a row.
double stretchOf(const Matrix& matrix) {
  double largest = 0;
  for (int row = 0; row < 3; ++row) {
    largest = std::max(largest, std::fabs(matrix.at(row, 0)) + std::fabs(matrix.at(row, 1)) +
                                    std::fabs(matrix.at(row, 2)));
  }
  return largest;
}

/// The most by which matrix * inverse moves a point whose coordinates are at most `magnitude`.
double residueOf(const Transform& transform, double magnitude) {
  const Matrix product = transform.getMatrix() * transform.getInverse();
  double largest = 0;
  for (int row = 0; row < 3; ++row) {
    double sum = std::fabs(product.at(row, 3));
    for (int column = 0; column < 3; ++column) {
      sum += std::fabs(product.at(row, column) - (row == column ? 1 : 0)) * magnitude;
    }
    largest = std::max(largest, sum);
  }
  return largest;
}

double magnitudeOf(const Matrix& matrix, double magnitude) {
  return matrix.magnitudeAt({magnitude, magnitude, magnitude});
}

/// What is known of the numbers in one space.
struct Numbers {
  double largest;  // of any coordinate of a ray's origin or point
  double error;    // of a point, in the world
};

Numbers inside(const GridSpace& space, const Matrix& parentToWorld, const Numbers& parent) {
  const Transform& transform = *space.transform;
  Numbers numbers{};
  numbers.largest = magnitudeOf(transform.getInverse(), parent.largest);
  const double throughMap = residueOf(transform, parent.largest) +
                            kUnit * magnitudeOf(transform.getMatrix(), numbers.largest);
  numbers.error = parent.error + stretchOf(parentToWorld) * throughMap +
                  stretchOf(space.toWorld) * kUnit * numbers.largest;
  return numbers;
}

}  // namespace

GridParts::GridParts(const Object3D& root) {
  add(&root, GridSpace::kWorld);
  std::vector<PlacedObject> listed;
  listed.swap(placed_);
  for (const PlacedObject& object : listed) {
    BoundingBox box;
    object.object->addBounds(toWorld(object.space), box);
    if (object.mesh && box.isEmpty()) continue;
    if (!isMeasurable(object, box)) {
      beside_.push_back(object);
      continue;
    }
    box_.extend(box);
    placed_.push_back(object);
  }
  findMargins();
}

/// The depth of recursion is the scene's nesting.
void GridParts::add(const Object3D* object, int space) {
  if (const auto* group = exactly<Group>(object)) {
    for (const Object3D* member : group->getObjects()) {
      if (member) add(member, space);
    }
    return;
  }
  if (const auto* transform = exactly<Transform>(object)) {
    spaces_.push_back({transform, space, toWorld(space) * transform->getMatrix()});
    add(transform->getObject(), int(spaces_.size()) - 1);
    return;
  }
  addPrimitive(object, space);
}

void GridParts::addPrimitive(const Object3D* object, int space) {
  PlacedObject placed{};
  placed.object = object;
  placed.mesh = exactly<TriangleMesh>(object);
  placed.space = space;
  placed.order = std::uint32_t(placed_.size());
  placed_.push_back(placed);
}

const Matrix& GridParts::toWorld(int space) const {
  return space == GridSpace::kWorld ? identity_ : spaces_[std::size_t(space)].toWorld;
}

/// True where squares and cubes of its numbers neither overflow nor underflow.
bool GridParts::isMeasurable(const PlacedObject& object, const BoundingBox& box) const {
  if (!object.object->isBounded() || box.isEmpty()) return false;
  BoundingBox own;
  object.object->addBounds(Matrix(), own);
  for (const BoundingBox& each : {box, own}) {
    const double largest = std::max(maxAbs(each.low()), maxAbs(each.high()));
    if (!(largest < kLargest && each.longestSide() > kSmallest)) return false;
  }
  return true;
}

void GridParts::findMargins() {
  if (box_.isEmpty()) return;
  const double size = box_.longestSide();
  reach_ = size * kReach + std::max(maxAbs(box_.low()), maxAbs(box_.high()));
  const Numbers world = {4 * reach_, 4 * reach_ * kUnit};
  std::vector<Numbers> all;
  const auto numbersIn = [&](int space) {
    return space == GridSpace::kWorld ? world : all[std::size_t(space)];
  };
  for (const GridSpace& space : spaces_) {
    all.push_back(inside(space, toWorld(space.parent), numbersIn(space.parent)));
  }
  for (PlacedObject& object : placed_)
    object.margin = numbersIn(object.space).error + size * kSlack;
  const auto vague =
      std::stable_partition(placed_.begin(), placed_.end(), [&](const PlacedObject& object) {
        return object.margin < size * kLargestMargin &&
               numbersIn(object.space).largest < kLargest &&
               stretchOf(toWorld(object.space)) < kLargest;
      });
  beside_.insert(beside_.end(), vague, placed_.end());
  placed_.erase(vague, placed_.end());
}

BoundingBox GridParts::boxOf(const PlacedObject& object, std::uint32_t first,
                             std::uint32_t last) const {
  const Matrix& matrix = toWorld(object.space);
  BoundingBox box;
  if (!object.mesh) {
    object.object->addBounds(matrix, box);
    return box;
  }
  for (std::uint32_t face = first; face < last; ++face) {
    for (int corner = 0; corner < 3; ++corner) {
      box.extend(matrix.transformPoint(object.mesh->getGeometry().corner(face, corner)));
    }
  }
  return box;
}

PartShape GridParts::shapeOf(const PlacedObject& object, std::uint32_t part) const {
  const Matrix& matrix = toWorld(object.space);
  if (const auto* sphere = exactly<Sphere>(object.object)) {
    return PartShape::ball(matrix, sphere->getCenter(), sphere->getRadius());
  }
  const auto* triangle = exactly<Triangle>(object.object);
  if (!object.mesh && !triangle) return {};
  const auto corner = [&](int number) {
    return matrix.transformPoint(triangle ? triangle->getVertex(number)
                                          : object.mesh->getGeometry().corner(part, number));
  };
  return PartShape::triangle(corner(0), corner(1), corner(2));
}

}  // namespace accel
