// The tables of a wave. Surfaces are sorted by counting: which group is each one's, how many does
// each group have, and so how many come before it.
#include "render/wave_tables.h"

#include <algorithm>

namespace {

template <std::size_t kTables>
void takeColumns(Arena& arena, int rows, double* (*const (&tables)[kTables])[3]) {
  for (auto* table : tables) {
    for (double*& column : *table) column = arena.take<double>(std::size_t(rows));
  }
}

}  // namespace

WaveRays::WaveRays(Arena& arena, int rows, bool hasSources, bool hasIndices)
    : RayTable(arena, rows, hasSources) {
  count = 0;
  weight = arena.take<float>(std::size_t(rows));
  factor = arena.take<Vec3f>(std::size_t(rows));
  parent = arena.take<std::uint16_t>(std::size_t(rows));
  if (hasIndices) index = arena.take<float>(std::size_t(rows));
}

WaveLight::WaveLight(Arena& arena, int rows, bool hasSources) : RayTable(arena, rows, hasSources) {
  count = 0;
  surface = arena.take<std::uint16_t>(std::size_t(rows));
  takeColumns(arena, rows, {&color});
}

ColorFilterTable::ColorFilterTable(Arena& arena, int rows) {
  row = arena.take<std::uint16_t>(std::size_t(rows));
  exponent = arena.take<double>(std::size_t(rows));
  takeColumns(arena, rows, {&color});
}

void ColorFilterTable::add(const ColorFilter& filter, int ofRow) {
  row[count] = std::uint16_t(ofRow);
  setRowOf(color, count, Vec3d(filter.color));
  exponent[count++] = filter.exponent;
}

WaveSurfaces::WaveSurfaces(const WaveRays& rays, const HitTable& hits, WaveHit* met, int rows,
                           Arena& arena)
    : count(rows) {
  const auto size = std::size_t(rows);
  groups = arena.take<MaterialGroup>(size);
  ray = arena.take<std::uint16_t>(size);
  tmin = arena.take<double>(size);
  weight = arena.take<float>(size);
  takeColumns(arena, rows, {&view, &point, &normal, &sum});
  std::copy(normal, normal + 3, lit);
  sort(met, arena);
  for (int k = 0; k < rows; ++k) {
    const int row = met[k].ray, place = met[k].place;
    ray[place] = met[k].ray;
    weight[place] = met[k].isComponent ? rays.weight[row] * float(met[k].share) : rays.weight[row];
  }
  const auto take = [&](double* column, const double* from) {
    for (int k = 0; k < rows; ++k) column[k] = from[ray[k]];
  };
  for (int axis = 0; axis < 3; ++axis) {
    take(view[axis], rays.direction[axis]);
    take(point[axis], hits.point[axis]);
    take(normal[axis], hits.normal[axis]);
  }
  for (double* column : sum) std::fill(column, column + rows, 0.0);
}

void WaveSurfaces::sort(WaveHit* met, Arena& arena) {
  const Arena::Frame frame(arena);
  auto* groupOf = arena.take<std::uint16_t>(std::size_t(count));
  // The group that a material of such a number began last. Where two have the same bits, each may
  // have several groups.
  std::uint16_t latest[256] = {};
  for (int k = 0; k < count; ++k) {
    const Material* const material = met[k].material;
    std::uint16_t& group = latest[material->getNumber() & 255];
    if (groupCount == 0 || groups[group].material != material) {
      group = std::uint16_t(groupCount);
      groups[groupCount++] = {material, 0, 0};
    }
    ++groups[group].last;  // so many, for now
    groupOf[k] = group;
  }
  int first = 0;
  for (MaterialGroup* group = groups; group != groups + groupCount; ++group) {
    const int size = group->last;
    group->first = group->last = first;
    first += size;
  }
  for (int k = 0; k < count; ++k) met[k].place = std::uint16_t(groups[groupOf[k]].last++);
}
