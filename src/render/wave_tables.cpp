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

WaveSurfaces::WaveSurfaces(const WaveRays& rays, WaveHit* met, int rows, Arena& arena)
    : count(rows) {
  const auto size = std::size_t(rows);
  groups = arena.take<MaterialGroup>(size);
  ray = arena.take<std::uint16_t>(size);
  tmin = arena.take<double>(size);
  weight = arena.take<float>(size);
  takeColumns(arena, rows, {&view, &point, &normal, &sum});
  std::copy(normal, normal + 3, lit);
  const Arena::Frame frame(arena);
  auto* groupOf = arena.take<std::uint16_t>(size);
  makeGroups(met, groupOf);
  // Neighbours are mostly of one group: its end is kept while they are.
  for (int k = 0; k < count;) {
    MaterialGroup& group = groups[groupOf[k]];
    int place = group.last;
    for (const int number = groupOf[k]; k < count && groupOf[k] == number; ++k, ++place) {
      WaveHit& hit = met[k];
      hit.place = std::uint16_t(place);
      ray[place] = hit.ray;
      weight[place] = rays.weight[hit.ray];
      if (hit.isComponent) weight[place] *= float(hit.share);
    }
    group.last = place;
  }
}

/// Makes the groups, still empty where their surfaces will stand, and finds which each hit is of.
void WaveSurfaces::makeGroups(const WaveHit* met, std::uint16_t* groupOf) {
  // The group that a material of such a number began last. Where two have the same bits, each may
  // have several groups.
  std::uint16_t latest[256] = {};
  for (int k = 0; k < count;) {
    const Material* const material = met[k].material;
    std::uint16_t& group = latest[material->getNumber() & 255];
    if (groupCount == 0 || groups[group].material != material) {
      group = std::uint16_t(groupCount);
      groups[groupCount++] = {material, 0, 0};
    }
    const int first = k;
    for (; k < count && met[k].material == material; ++k) groupOf[k] = group;
    groups[group].last += k - first;  // so many, for now
  }
  int first = 0;
  for (MaterialGroup* group = groups; group != groups + groupCount; ++group) {
    const int size = group->last;
    group->first = group->last = first;
    first += size;
  }
}
