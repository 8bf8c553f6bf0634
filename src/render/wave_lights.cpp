// WaveTracer: the light that comes to the surfaces of a table from each lamp of the scene.
//
//   1. sampleLight: which surfaces are turned towards the light, and a shadow ray from each; these
//      rays are a table of their own, in the order of the surfaces.
//   2. findVisible: the rays are asked together what is in their way. Rows of which nothing arrives
//      drop out; with tinted shadows the colour becomes what does.
//   3. reflect: each group of one material adds to its surfaces' sums what they send back.
#include "render/transmittance.h"
#include "render/wave_kernels.h"
#include "render/wave_tracer.h"

/// Adds to each sum what light `index` brings there.
void WaveTracer::addLight(int index, const WaveGeneration& generation,
                          const WaveSurfaces& surfaces) {
  const Arena::Frame frame(arena_);
  WaveLight light(arena_, surfaces.count, hasSources_);
  sampleLight(index, generation, surfaces, light);
  const RowList visible = findVisible(light);
  const std::uint16_t* row = visible.begin();
  for (int g = 0; g < surfaces.groupCount; ++g) {
    const std::uint16_t* const first = row;
    while (row != visible.end() && light.surface[*row] < surfaces.groups[g].last) ++row;
    if (row == first) continue;
    reflect(surfaces.groups[g], generation, light, {first, int(row - first)}, surfaces);
  }
}

/// Makes the shadow rays from surfaces that are turned towards the light.
void WaveTracer::sampleLight(int index, const WaveGeneration& generation,
                             const WaveSurfaces& surfaces, WaveLight& light) const {
  const Light& asked = *tracer_.scene().getLight(index);
  LightNumbers numbers;
  numbers.isSeenBehind = tracer_.scene().hasHighlightsBehind();
  if (toNumbers(asked, numbers)) {
    kernels_.sampleLight(numbers, surfaces, light);
  } else {
    for (int k = 0; k < surfaces.count; ++k) {
      Vec3d direction;
      Vec3f color;
      double distance;
      asked.getIllumination(rowOf(surfaces.point, k), direction, color, distance);
      if (!isLit(rowOf(surfaces.lit, k), direction, numbers.isSeenBehind)) continue;
      light.surface[light.count] = std::uint16_t(k);
      setRowOf(light.origin, light.count, rowOf(surfaces.point, k));
      setRowOf(light.direction, light.count, direction);
      setRowOf(light.color, light.count, color);
      light.tmin[light.count] = surfaces.tmin[k];
      light.tmax[light.count++] = distance;
    }
  }
  for (int row = 0; light.source && row < light.count; ++row) {
    const int ray = surfaces.ray[light.surface[row]];
    light.source[row] = generation.hits.object[ray];
    light.sourceFace[row] = generation.hits.face[ray];
  }
}

/// The rows of the light of which anything arrives; its colour becomes what does.
RowList WaveTracer::findVisible(WaveLight& light) {
  const RenderOptions& options = tracer_.shader().options();
  if (!options.shadows) return RowList::all(light.count, arena_);
  auto* rows = arena_.take<std::uint16_t>(std::size_t(light.count));
  int count = 0;
  if (!options.transparentShadows) {
    auto* blocked = arena_.take<bool>(std::size_t(light.count));
    batches().occludedAll(light, blocked, arena_);
    for (int row = 0; row < light.count; ++row) {
      if (!blocked[row]) rows[count++] = std::uint16_t(row);
    }
  } else {
    auto* visible = arena_.take<Vec3f>(std::size_t(light.count));
    transmittances(batches(), light, arena_, visible);
    for (int row = 0; row < light.count; ++row) {
      if (visible[row] == Vec3f()) continue;
      setRowOf(light.color, row, Vec3f(rowOf(light.color, row)) * visible[row]);
      rows[count++] = std::uint16_t(row);
    }
  }
  if (counts_) {
    counts_->addShadowRays(std::size_t(light.count), std::size_t(light.count - count));
  }
  return {rows, count};
}

/// Adds what the surfaces of a group send back of the listed light.
void WaveTracer::reflect(const MaterialGroup& group, const WaveGeneration& generation,
                         const WaveLight& light, const RowList& rows,
                         const WaveSurfaces& surfaces) const {
  PhongNumbers numbers;
  if (toNumbers(*group.material, numbers)) return kernels_.reflect(numbers, light, rows, surfaces);
  for (const int row : rows) {
    const int k = light.surface[row], ray = surfaces.ray[k];
    const Hit hit = generation.hitOf(ray).withSurface(group.material, rowOf(surfaces.lit, k));
    surfaces.add(k, group.material->Shade(generation.rays.rayOf(ray), hit,
                                          Vec3f(rowOf(light.direction, row)),
                                          Vec3f(rowOf(light.color, row))));
  }
}
