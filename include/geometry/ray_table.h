// RayTable and HitTable: many rays, and what each of them has met, in columns.
// A column holds one number of every ray, so that vectors of several rays are loaded and stored as
// they lie in memory. Columns are an Arena's, which the tables do not own.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/object3d.h"
#include "math/simd_level.h"
#include "system/arena.h"

/// Some rows of a table, in the order in which they are asked.
struct RowList {
  const std::uint16_t* rows;
  int count;

  /// Rows 0 to count - 1.
  static RowList all(int count, Arena& arena) {
    auto* rows = arena.take<std::uint16_t>(std::size_t(count));
    for (int row = 0; row < count; ++row) rows[row] = std::uint16_t(row);
    return {rows, count};
  }

  const std::uint16_t* begin() const { return rows; }
  const std::uint16_t* end() const { return rows + count; }
};

/// Row `row` of three columns.
inline Vec3d rowOf(const double* const column[3], int row) {
  return {column[0][row], column[1][row], column[2][row]};
}
inline void setRowOf(double* const column[3], int row, const Vec3d& v) {
  for (int axis = 0; axis < 3; ++axis) column[axis][row] = v[axis];
}

/// Rays, in one space. Row i is ray i.
struct RayTable {
  /// The most rows of a table: a tile of 32 x 32 pixels. What is known of more leaves the
  /// processor's second cache.
  static constexpr int kMost = 1024;

  int count = 0;         ///< of rows
  double* origin[3];     ///< finite
  double* direction[3];  ///< not zero; its length is the unit of t
  double* tmin;          ///< only surfaces at t > tmin count
  double* tmax;          ///< only surfaces at t < tmax count
  /// The surface that each ray leaves and its face, as Ray::setSource has them. Both null where no
  /// ray leaves any.
  const Object3D** source = nullptr;
  std::uint32_t* sourceFace = nullptr;

  /// Columns for `rows` rows, which are still to be filled.
  RayTable(Arena& arena, int rows, bool hasSources);

  Vec3d originOf(int row) const { return rowOf(origin, row); }
  Vec3d directionOf(int row) const { return rowOf(direction, row); }
  Ray rayOf(int row) const {
    Ray ray(originOf(row), directionOf(row));
    if (source) ray.setSource(source[row], sourceFace[row]);
    return ray;
  }
  /// `ray` leaves no surface where there are no columns for it.
  void setRow(int row, const Ray& ray, double least, double most);
};

/// The nearest hit that a search has found so far, and its order in the scene.
struct NearestSoFar {
  /// The order of no primitive: nothing was found.
  static constexpr std::uint32_t kNothing = 0xffffffffu;

  double t;  ///< or the bound of the search
  std::uint32_t order = kNothing;
  std::uint32_t face = 0;

  /// Whether a hit comes before it: it is nearer, or as near and earlier in the scene.
  bool accepts(double newT, std::uint32_t newOrder, std::uint32_t newFace = 0) const {
    return newT < t || (newT == t && order != kNothing &&
                        (newOrder < order || (newOrder == order && newFace < face)));
  }
  /// A bound that lets equal t through where they may come before, for functions that demand less.
  double inclusiveBound() const {
    return order == kNothing ? t : std::nextafter(t, std::numeric_limits<double>::infinity());
  }
};

/// The nearest hits of the rays of a RayTable, in which tmax is the t of the hit. Where nothing was
/// found, all but the order may be anything.
struct HitTable {
  const Material** material;  ///< not owned
  const Object3D** object;    ///< the primitive; not owned
  std::uint32_t* face;        ///< which triangle of a mesh; 0 for all else
  std::uint32_t* order;       ///< the primitive's in the scene, or NearestSoFar::kNothing
  double* magnitude;          ///< as magnitudeOf gives it
  double* normal[3];          ///< unit
  double* point[3];
  Vec2d* textureCoordinates;           ///< anything, unless hasTextureCoordinates
  bool hasTextureCoordinates = false;  ///< any row has been given one other than (0, 0)
  int rowCount;                        ///< for which there is room

  /// Columns for `rows` rows, in which nothing is found.
  HitTable(Arena& arena, int rows);

  bool isFound(int row) const { return order[row] != NearestSoFar::kNothing; }
  /// Of a row where something is found.
  Vec2d textureCoordinatesOf(int row) const {
    const bool isThere =
        hasTextureCoordinates && object[row] && object[row]->hasTextureCoordinates();
    return isThere ? textureCoordinates[row] : Vec2d();
  }
  void setTextureCoordinates(int row, const Vec2d& coordinates) {
    if (!hasTextureCoordinates) {
      if (coordinates.x() == 0 && coordinates.y() == 0) return;
      std::fill(textureCoordinates, textureCoordinates + rowCount, Vec2d());
      hasTextureCoordinates = true;
    }
    textureCoordinates[row] = coordinates;
  }
  /// Row `row` as a Hit, `t` being the ray's tmax; Hit(t) where nothing is found.
  Hit hitOf(int row, double t) const;
  /// Takes all of a hit but its t.
  void setRow(int row, const Hit& hit, std::uint32_t newOrder);
};

/// Is told where the rays of a table pass through surfaces.
class RowCrossingVisitor {
 public:
  virtual ~RowCrossingVisitor() = default;
  /// Called as CrossingVisitor::visit for every crossing of ray `row`, in no particular order.
  virtual void visit(int row, const Crossing& crossing) = 0;
};

/// Tells a RowCrossingVisitor of the crossings of one ray.
class CrossingsOfRow : public CrossingVisitor {
 public:
  CrossingsOfRow(int row, RowCrossingVisitor& visitor) : row_(row), visitor_(visitor) {}
  void visit(const Crossing& crossing) override { visitor_.visit(row_, crossing); }

 private:
  const int row_;
  RowCrossingVisitor& visitor_;
};

/// Answers the questions of many rays in one call: by default through an object's own functions,
/// one ray after the other. Rays that are asked together visit a node of a tree together, which
/// then costs less than once for each. Each answer is that of the ray alone. All are const while
/// rays are traced; `arena` is the caller's, for this thread.
class BatchGeometry {
 public:
  /// Not owned.
  explicit BatchGeometry(const Object3D& geometry) : geometry_(&geometry) {}
  virtual ~BatchGeometry() = default;

  /// Object3D::intersect for all rays of the table. Where something is found, the ray's tmax
  /// becomes its t, and its row of `hits`, in which nothing was found before, is set.
  virtual void intersectAll(const RayTable& rays, HitTable& hits, Arena& arena) const;
  /// Object3D::occluded for all rays of the table; stores each answer in blocked[row].
  virtual void occludedAll(const RayTable& rays, bool* blocked, Arena& arena) const;
  /// Object3D::visitCrossings for all rays of the table, but what a ray crosses nowhere at t < tmax
  /// may be left out: each object is told of with all its crossings, before and behind tmax, or not
  /// at all. tmin is taken no notice of.
  virtual void visitAllCrossings(const RayTable& rays, RowCrossingVisitor& visitor,
                                 Arena& arena) const;
  /// The instruction set that it uses, one that the processor has.
  virtual SimdLevel simdLevel() const { return availableSimd(SimdLevel::automatic); }

 private:
  const Object3D* geometry_;
};
