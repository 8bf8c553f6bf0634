// RayTable and HitTable: from rows to columns and back, and rays asked one by one.
//
// All columns of numbers come out of one piece of memory. What few hits have, such as texture
// coordinates, is cleared when the first of them is set.
#include "geometry/ray_table.h"

#include <algorithm>

namespace {

/// A column of T behind each other for each of `count` pointers, with room for a vector to run over
/// the end of each: one take, for tables of a few rows are made often.
template <class T>
void takeColumns(Arena& arena, int rows, T** const* columns, std::size_t count) {
  constexpr std::size_t kLine = Arena::kAlignment / sizeof(T);
  const std::size_t stride = (std::size_t(rows) + 2 * kLine - 1) / kLine * kLine;
  T* first = arena.take<T>(stride * count);
  for (std::size_t i = 0; i < count; ++i) *columns[i] = first + i * stride;
}

}  // namespace

RayTable::RayTable(Arena& arena, int rows, bool hasSources) : count(rows) {
  double** const columns[] = {&origin[0],    &origin[1],    &origin[2], &direction[0],
                              &direction[1], &direction[2], &tmin,      &tmax};
  takeColumns(arena, rows, columns, 8);
  if (!hasSources) return;
  const auto size = std::size_t(rows);
  source = arena.take<const Object3D*>(size);
  sourceFace = arena.take<std::uint32_t>(size);
}

void RayTable::setRow(int row, const Ray& ray, double least, double most) {
  setRowOf(origin, row, ray.getOrigin());
  setRowOf(direction, row, ray.getDirection());
  tmin[row] = least;
  tmax[row] = most;
  if (!source) return;
  source[row] = ray.getSource();
  sourceFace[row] = ray.getSourceFace();
}

HitTable::HitTable(Arena& arena, int rows) : rowCount(rows) {
  const auto size = std::size_t(rows);
  material = arena.take<const Material*>(size);
  object = arena.take<const Object3D*>(size);
  face = arena.take<std::uint32_t>(size);
  order = arena.take<std::uint32_t>(size);
  textureCoordinates = arena.take<Vec2d>(size);
  double** const columns[] = {&magnitude, &normal[0], &normal[1], &normal[2],
                              &point[0],  &point[1],  &point[2]};
  takeColumns(arena, rows, columns, 7);
  std::fill(order, order + size, NearestSoFar::kNothing);
}

Hit HitTable::hitOf(int row, double t) const {
  Hit hit(t);
  if (!isFound(row)) return hit;
  hit.record(t, material[row], rowOf(normal, row), rowOf(point, row),
             {object[row], face[row], magnitude[row], textureCoordinatesOf(row)});
  return hit;
}

void HitTable::setRow(int row, const Hit& hit, std::uint32_t newOrder) {
  material[row] = hit.getMaterial();
  object[row] = hit.getObject();
  face[row] = hit.getFace();
  order[row] = newOrder;
  magnitude[row] = hit.getMagnitude();
  setRowOf(normal, row, hit.getNormal());
  setRowOf(point, row, hit.getIntersectionPoint());
  setTextureCoordinates(row, hit.getTextureCoordinates());
}

void BatchGeometry::intersectAll(const RayTable& rays, HitTable& hits, Arena&) const {
  for (int row = 0; row < rays.count; ++row) {
    Hit hit(rays.tmax[row]);
    if (!geometry_->intersect(rays.rayOf(row), hit, rays.tmin[row])) continue;
    rays.tmax[row] = hit.getT();
    hits.setRow(row, hit, 0);
  }
}

void BatchGeometry::occludedAll(const RayTable& rays, bool* blocked, Arena&) const {
  for (int row = 0; row < rays.count; ++row) {
    blocked[row] = geometry_->occluded(rays.rayOf(row), rays.tmin[row], rays.tmax[row]);
  }
}

void BatchGeometry::visitAllCrossings(const RayTable& rays, RowCrossingVisitor& visitor,
                                      Arena&) const {
  for (int row = 0; row < rays.count; ++row) {
    CrossingsOfRow crossings(row, visitor);
    geometry_->visitCrossings(rays.rayOf(row), crossings);
  }
}
