// ObjectTree: sorting the members into the tree. What it answers afterwards is in
// asked_objects.cpp.
//
//   1. Each member gets its box: a mesh that of its tree, a Transform the box of the moved corners
//      of its inside's box. Without a box, or with numbers whose squares leave the range of double,
//      a member is asked one by one; triangles without area are left out. Those that are very small
//      beside the space get trees of their own (gathered_members.cpp).
//   2. The tree's normalised space is chosen: the middle of all boxes is the anchor, and a power of
//      two scales the longest side to 1 to 2. Boxes are rounded outwards there, to float.
//   3. The builder makes the nodes; leaves are written here: spheres and triangles in numbers that
//      the kernels can test, everything else as its whole member, with a copy of the inverse of the
//      Transform that it stands under.
// Transforms below make hits less exact than the kernels' error bounds say; by how much is noted in
// the tree, and rays are prepared with boxes that are wider by that.
#include "accel/object_tree.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <utility>

#include "accel/bvh_builder.h"
#include "accel/mesh_tree.h"
#include "geometry/plane.h"
#include "geometry/sphere.h"
#include "geometry/triangle.h"

namespace accel {
namespace {

/// Up to so many objects, meshes or spaces, and planes and spheres, are asked one by one: a tree
/// would not pay. Eight rays ask a sphere in 10 ns, and take 500 ns for their way through a small
/// tree; six meshes without one took 0.95 of the instructions of a picture of wine glasses.
constexpr std::size_t kFewObjects = 3, kFewMeshes = 8, kFewShapes = 20;

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

/// Under a Transform, the box of a box's corners. One around the moved boxes of a mesh's two
/// uppermost levels is smaller, but spared only 3 % of the nodes with 10,000 turned meshes.
BoundingBox boxOf(const TreeMember& member) {
  BoundingBox box;
  if (member.kind == TreeMember::Kind::plain) {
    member.object->addBounds(Matrix(), box);
    return box;
  }
  box = member.kind == TreeMember::Kind::mesh ? member.meshTree->box() : member.objectTree->box();
  if (!member.inverse) return box;
  return box.moved(static_cast<const Transform*>(member.object)->getMatrix());
}

bool isBounded(const TreeMember& member) {
  return member.kind == TreeMember::Kind::tree ? member.objectTree->isBounded()
                                               : member.object->isBounded();
}

LeafKind leafKindOf(const TreeMember& member) {
  if (member.kind != TreeMember::Kind::plain) return LeafKind::objects;
  if (exactly<Sphere>(member.object)) return LeafKind::spheres;
  if (exactly<Triangle>(member.object)) return LeafKind::looseTriangles;
  return LeafKind::objects;
}

/// True where no ray can ever hit the object.
bool isNothing(const TreeMember& member) {
  const auto* triangle = exactly<Triangle>(member.object);
  return triangle && !triangle->hasArea();
}

/// True where a box tells where the object is hit: beyond these sizes, squares in the double
/// functions of spheres and triangles overflow or underflow, and their answers are arbitrary.
bool isMeasurable(const BoundingBox& box) {
  const double largest = box.longestSide() + maxAbs(box.low()) + maxAbs(box.high());
  return largest < 0x1p500 && box.longestSide() > 0x1p-450;
}

/// Writes leaves of loose triangles, spheres and other objects, in the space of `bvh`.
class ObjectLeafWriter : public LeafWriter {
 public:
  ObjectLeafWriter(const std::vector<TreeMember>& entries, const WideBvh& bvh)
      : members_(entries), bvh_(bvh) {}

  int write(const BuildItem* items, int count, std::uint32_t* words) const override {
    const LeafKind kind = items[0].kind;
    if (kind == LeafKind::objects) return writeObject(members_[items[0].id], words);
    float edge = 0;
    for (int i = 0; i < count; ++i) {
      const Object3D* object = members_[items[i].id].object;
      std::uint32_t* column = words + 1 + i;
      if (kind == LeafKind::looseTriangles) {
        edge = std::max(edge, writeTriangle(static_cast<const Triangle&>(*object), column, count));
      } else {
        writeSphere(static_cast<const Sphere&>(*object), column, count);
      }
      column[rowsOf(kind) * count] = items[i].id | kIdBit;
    }
    words[0] = leafHead(edge, kind, count);
    return 1 + (rowsOf(kind) + 1) * count;
  }

 private:
  static int writeObject(const TreeMember& member, std::uint32_t* words) {
    constexpr int kMember = sizeof member / sizeof *words, kMatrix = sizeof(Matrix) / sizeof *words;
    static_assert(kMember + kMatrix <= kMostObjectWords);
    words[0] = leafHead(0, LeafKind::objects, 1);
    std::memcpy(words + 1, &member, sizeof member);
    if (!member.inverse) return 1 + kMember;
    std::memcpy(words + 1 + kMember, member.inverse, sizeof(Matrix));
    return 1 + kMember + kMatrix;
  }
  Vec3d normalized(const Vec3d& p) const {
    return (p - Vec3d(bvh_.anchor[0], bvh_.anchor[1], bvh_.anchor[2])) * bvh_.scale;
  }
  static void put(const Vec3f& v, int row, std::uint32_t* column, int stride) {
    for (int axis = 0; axis < 3; ++axis) {
      const float value = v[axis];
      std::memcpy(column + (row + axis) * stride, &value, sizeof value);
    }
  }
  /// Returns the largest component of an edge.
  float writeTriangle(const Triangle& triangle, std::uint32_t* column, int stride) const {
    const Vec3d& v0 = triangle.getVertex(0);
    const Vec3f e1((triangle.getVertex(1) - v0) * bvh_.scale),
        e2((triangle.getVertex(2) - v0) * bvh_.scale);
    put(Vec3f(normalized(v0)), 0, column, stride);
    put(e1, 3, column, stride);
    put(e2, 6, column, stride);
    return std::max(maxAbs(e1), maxAbs(e2));
  }
  void writeSphere(const Sphere& sphere, std::uint32_t* column, int stride) const {
    put(Vec3f(normalized(sphere.getCenter())), 0, column, stride);
    const float radius = float(sphere.getRadius() * bvh_.scale);
    std::memcpy(column + 3 * stride, &radius, sizeof radius);
  }

  const std::vector<TreeMember>& members_;
  const WideBvh& bvh_;
};

/// Error beyond this leaves everything open, and is still held by all numbers made of it.
double limitedError(double error) { return error < 0x1p60 ? error : 0x1p60; }

/// Notes the error for origins that are measured from the anchor, in normalised units.
void setTransformError(const TransformError& error, WideBvh& bvh) {
  const double anchor =
      std::max({std::fabs(bvh.anchor[0]), std::fabs(bvh.anchor[1]), std::fabs(bvh.anchor[2])});
  bvh.errorFactor = 1 + limitedError(error.perSize);
  bvh.fixedError = limitedError((error.perSize * anchor + error.fixed) * bvh.scale);
}

/// Hits are off by at most 2^-47 of what `error` says of the numbers that they are computed of. An
/// empty box becomes an infinite one.
BoxNumbers numbersOf(const BoundingBox& box, const TransformError& error) {
  constexpr double kSlack = 0x1p-44, kInfinity = std::numeric_limits<double>::infinity();
  const Vec3d farthest(kInfinity, kInfinity, kInfinity);
  if (box.isEmpty()) return numbersOf({-farthest, farthest}, {});
  const double slack = (1 + error.perSize) * kSlack;
  const double size = std::max(maxAbs(box.low()), maxAbs(box.high()));
  const double margin = 0x1p-18 * box.longestSide() + slack * size + error.fixed * kSlack;
  BoxNumbers numbers{{}, {}, slack};
  for (int axis = 0; axis < 3; ++axis) {
    numbers.low[axis] = box.low()[axis] - margin;
    numbers.high[axis] = box.high()[axis] + margin;
  }
  return numbers;
}

/// The box in the space of the tree, rounded outwards.
BuildItem itemOf(const BoundingBox& box, const WideBvh& bvh, std::uint32_t id, LeafKind kind) {
  BuildItem item{};
  for (int axis = 0; axis < 3; ++axis) {
    const double anchor = bvh.anchor[axis], scale = bvh.scale;
    item.low[axis] = std::nextafter(float((box.low()[axis] - anchor) * scale), -kFloatInfinity);
    item.high[axis] = std::nextafter(float((box.high()[axis] - anchor) * scale), kFloatInfinity);
  }
  item.id = id;
  item.kind = kind;
  return item;
}

/// What a Transform holds, or the object itself.
const Object3D* primitiveOf(const TreeMember& member) {
  const auto* transform = exactly<Transform>(member.object);
  return transform ? transform->getObject() : member.object;
}

/// True for a plane or a sphere, perhaps under a Transform.
bool isShape(const TreeMember& member) {
  if (member.kind != TreeMember::Kind::plain) return false;
  const Object3D* primitive = primitiveOf(member);
  return exactly<Sphere>(primitive) || exactly<Plane>(primitive);
}

ShapeNumbers shapeOf(const TreeMember& member) {
  const auto* transform = exactly<Transform>(member.object);
  ShapeNumbers shape{};
  shape.object = primitiveOf(member);
  shape.whole = member.object;
  shape.inverse = transform ? &transform->getInverse() : nullptr;
  shape.order = member.order;
  Vec3d place;
  if (const auto* sphere = exactly<Sphere>(shape.object)) {
    place = sphere->getCenter();
    shape.isSphere = true;
    shape.size = sphere->getRadius();
    shape.extent = std::max(maxAbs(place), shape.size);
    shape.material = sphere->getMaterial();
  } else {
    const auto& plane = static_cast<const Plane&>(*shape.object);
    place = plane.getNormal();
    shape.size = plane.getOffset();
    shape.extent = std::fabs(shape.size);
    shape.material = plane.getMaterial();
  }
  for (int axis = 0; axis < 3; ++axis) shape.place[axis] = place[axis];
  return shape;
}

}  // namespace

/// Asks the member out of the tree.
void ObjectTree::askAlone(const BoxedMember& each) {
  if (isShape(members_[each.id])) {
    shapes_.push_back(shapeOf(members_[each.id]));
  } else {
    const double infinity = std::numeric_limits<double>::infinity();
    const double size = each.box.isEmpty() ? infinity : each.box.longestSide();
    direct_.push_back({numbersOf(each.box, error_), size, each.id});
  }
}

/// Leaves those members out of the tree of which isOut(each) is true.
template <class IsOut>
void ObjectTree::leaveOut(std::vector<BoxedMember>& boxed, const IsOut& isOut) {
  const auto out = std::stable_partition(boxed.begin(), boxed.end(),
                                         [&](const BoxedMember& each) { return !isOut(each); });
  for (auto each = out; each != boxed.end(); ++each) askAlone(*each);
  boxed.erase(out, boxed.end());
}

void ObjectTree::finish(int threads) {
  std::vector<BoxedMember> boxed;
  std::size_t shapeCount = 0, plainCount = 0;
  for (std::uint32_t id = 0; id < members_.size(); ++id) {
    const TreeMember& member = members_[id];
    if (isNothing(member)) continue;
    const BoundingBox box = accel::isBounded(member) ? boxOf(member) : BoundingBox();
    const bool isInBox = box.isEmpty() || isMeasurable(box);
    // A Transform of this space then has no box either.
    if (!accel::isBounded(member) || !isInBox) bounded_ = false;
    if (box.isEmpty() || !isInBox) {
      askAlone({BoundingBox(), id});
      continue;
    }
    box_.extend(box);
    boxed.push_back({box, id});
    if (isShape(member)) {
      ++shapeCount;
    } else if (member.kind == TreeMember::Kind::plain) {
      ++plainCount;
    }
  }
  const bool areFewShapes = shapeCount <= kFewShapes;
  const bool areFew = areFewShapes && plainCount <= kFewObjects &&
                      boxed.size() - shapeCount - plainCount <= kFewMeshes;
  leaveOut(boxed, [&](const BoxedMember& each) {
    return areFew || (areFewShapes && isShape(members_[each.id]));
  });
  gatherSmall(boxed, threads);
  const bool areFewBesideTrees = !gathered_.empty() && boxed.size() <= kFewObjects;
  leaveOut(boxed, [&](const BoxedMember&) { return areFewBesideTrees; });
  if (!boxed.empty()) build(std::move(boxed), threads);
  // Large ones need not be asked for rays that a small one before them has stopped.
  std::sort(direct_.begin(), direct_.end(), [](const DirectMember& a, const DirectMember& b) {
    return std::tie(a.size, a.id) < std::tie(b.size, b.id);
  });
  // Of two at the same t the kernels keep the first.
  std::sort(shapes_.begin(), shapes_.end(),
            [](const ShapeNumbers& a, const ShapeNumbers& b) { return a.order < b.order; });
}

/// Sorts members into the tree.
void ObjectTree::build(std::vector<BoxedMember> boxed, int threads) {
  // The error bounds of loose triangles want the anchor to be in their middle, whatever else there
  // is in the space.
  BoundingBox around;
  for (const BoxedMember& each : boxed) around.extend(each.box);
  const Vec3d middle = around.low() + (around.high() - around.low()) * 0.5;
  for (int axis = 0; axis < 3; ++axis) bvh_.anchor[axis] = middle[axis];
  const double longest = std::max(around.longestSide(), std::numeric_limits<double>::min());
  bvh_.scale = std::ldexp(1.0, std::clamp(-std::ilogb(longest), -1000, 1000));
  setTransformError(error_, bvh_);
  BuildItems items(boxed.size());
  for (const BoxedMember& each : boxed) {
    TreeMember& member = members_[each.id];
    const LeafKind kind = leafKindOf(member);
    items.add(itemOf(each.box, bvh_, each.id, kind));
    if (kind != LeafKind::objects || !isShape(member)) continue;
    member.shape = &inTree_.emplace_back(shapeOf(member));
    member.kind = TreeMember::Kind::shape;
  }
  boxed = {};
  ThreadPool::run(threads, items.count(), [&](ThreadPool& pool) {
    buildWideBvh(bvh_, std::move(items), ObjectLeafWriter(members_, bvh_), pool);
  });
}

}  // namespace accel
