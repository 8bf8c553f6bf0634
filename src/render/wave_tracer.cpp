// WaveTracer: one step of the recursion for all rays of a table, then the next step.
//
//   trace     meet: what do the rays hit, and what lies on both sides of it?
//             each hit becomes a surface; that of a solid texture one for each component
//   shade     the four terms, each for all surfaces, those of one material side by side
//               lights       a table of shadow rays for one light, asked together
//               ambient
//               mirror       a table of the rays that continue; trace, one bounce deeper
//               transmitted  likewise, in the same table behind the mirrored ones
// A table has RayTable::kMost rows at most, and is traced before it overflows. So in memory there
// is one table of rays and one of surfaces for each bounce, up to kMostGenerations of them, after
// which rays go one by one.
#include "render/wave_tracer.h"

#include <algorithm>
#include <limits>

#include "render/wave_kernels.h"
#include "shading/solid_texture.h"

namespace {

/// Fewer rays than this fill no vector: a table of them would take more than it saves.
constexpr int kFewRays = 4;
/// Each generation keeps its tables while those after it are traced, up to half a megabyte.
constexpr int kMostGenerations = 64;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

/// The rays that continue at the surfaces of one table: first all mirrored, then all refracted
/// ones. They are traced when the table is full, and at the end.
class WaveTracer::Branches {
 public:
  Branches(WaveTracer& tracer, const WaveGeneration& generation, WaveSurfaces& surfaces)
      : tracer_(tracer),
        generation_(generation),
        surfaces_(surfaces),
        next_(tracer.arena_, std::min(2 * surfaces.count, RayTable::kMost), tracer.hasSources_,
              tracer.tracer_.shader().followsIndex()) {
    const auto most = std::size_t(surfaces.count);
    places_ = tracer.arena_.take<std::uint16_t>(most);
    before_ = tracer.arena_.take<double>(most);
    behind_ = tracer.arena_.take<double>(most);
  }

  void addAll() {
    for (const RayKind kind : {RayKind::mirror, RayKind::refracted}) {
      for (int k = 0; k < surfaces_.groupCount; ++k) add(kind, surfaces_.groups[k]);
    }
    flush();
  }

 private:
  void add(RayKind kind, const MaterialGroup& group) {
    const Shader& shader = tracer_.tracer_.shader();
    if (!shader.sends(kind, *group.material)) return;
    for (int first = group.first; first < group.last;) {
      if (next_.count == capacity()) flush();
      const int last = std::min(group.last, first + capacity() - next_.count);
      const int count = follow(kind, *group.material, first, last);
      kind == RayKind::mirror ? addMirrored(count) : addRefracted(count, *group.material);
      first = last;
    }
  }
  int capacity() const { return std::min(2 * surfaces_.count, RayTable::kMost); }

  /// Makes those of [first, last) at which a ray follows parents in the table, behind its rays,
  /// with weight and factor, and returns their number.
  int follow(RayKind kind, const Material& material, int first, int last) {
    const Shader& shader = tracer_.tracer_.shader();
    if (!generation_.interfaces && !shader.areFactorsAngular()) {
      return followAlike(kind, material, first, last);
    }
    int count = 0;
    for (int k = first; k < last; ++k) {
      const double approach = dot(rowOf(surfaces_.normal, k), rowOf(surfaces_.view, k));
      Interface interface = generation_.interfaceOf(surfaces_.ray[k], approach);
      if (next_.index) interface.before = {false, generation_.rays.indexOf(surfaces_.ray[k])};
      const Vec3f factor = shader.factorOf(kind, material, interface, approach);
      const int row = next_.count + count;
      const Outcome outcome = shader.outcomeOf(generation_.bounces, surfaces_.weight[k], factor,
                                               interface.tint, next_.weight[row]);
      countEnds(outcome, 1);
      if (outcome != Outcome::follows) continue;
      next_.parent[row] = std::uint16_t(k);
      next_.factor[row] = factor;
      before_[count] = double(interface.before.indexAt(material));
      behind_[count++] = double(interface.behind.indexAt(material));
    }
    return count;
  }

  /// The same where interfaces are plain, so that all surfaces have one factor, and a weight
  /// decides.
  int followAlike(RayKind kind, const Material& material, int first, int last) {
    const Shader& shader = tracer_.tracer_.shader();
    const Interface plain;
    const Vec3f factor = shader.factorOf(kind, material, plain, 0);
    float size = 0;
    if (shader.outcomeOf(generation_.bounces, 1, factor, plain.tint, size) ==
        Outcome::tooManyBounces) {
      countEnds(Outcome::tooManyBounces, last - first);
      return 0;
    }
    int row = next_.count;
    for (int k = first; k < last; ++k) {
      next_.parent[row] = std::uint16_t(k);
      next_.factor[row] = factor;
      next_.weight[row] = surfaces_.weight[k] * size;
      row += shader.isFaint(next_.weight[row]) ? 0 : 1;
    }
    const int count = row - next_.count;
    countEnds(Outcome::tooFaint, last - first - count);
    return count;
  }

  void countEnds(Outcome outcome, int count) {
    if (!tracer_.counts_ || outcome == Outcome::none || outcome == Outcome::follows) return;
    tracer_.counts_->addEnds(outcome, std::size_t(count));
  }

  void addMirrored(int count) {
    tracer_.kernels_.mirror({surfaces_, next_, count});
    append(count, before_);
    countRays(RayKind::mirror, count);
  }

  void addRefracted(int count, const Material& material) {
    RefractionNumbers numbers{tracer_.tracer_.shader().keepsStraight(),
                              double(material.getIndexOfRefraction()), nullptr, nullptr};
    if (generation_.interfaces || tracer_.tracer_.shader().areFactorsAngular()) {
      numbers.before = before_;
      numbers.behind = behind_;
    }
    const int kept = tracer_.kernels_.refract(numbers, {surfaces_, next_, count}, places_);
    for (int k = 0; k < kept; ++k) {
      const int row = next_.count + k, place = next_.count + places_[k];
      next_.weight[row] = next_.weight[place];
      next_.factor[row] = next_.factor[place];
      next_.parent[row] = next_.parent[place];
      if (next_.index) behind_[k] = behind_[places_[k]];
    }
    append(kept, behind_);
    countRays(RayKind::refracted, kept);
    countEnds(Outcome::totalReflection, count - kept);
  }

  /// The next `count` rays, which have origin, direction, weight, factor and parent, join the
  /// table. `indices` are those of the media where they go.
  void append(int count, const double* indices) {
    const int first = next_.count;
    next_.count += count;
    for (int row = first; row < next_.count; ++row) {
      const int surface = next_.parent[row];
      next_.tmin[row] = surfaces_.tmin[surface];
      next_.tmax[row] = kInfinity;
      if (next_.index) next_.index[row] = float(indices[row - first]);
      if (!next_.source) continue;
      next_.source[row] = generation_.hits.object[surfaces_.ray[surface]];
      next_.sourceFace[row] = generation_.hits.face[surfaces_.ray[surface]];
    }
  }
  void countRays(RayKind kind, int count) {
    if (tracer_.counts_ && count > 0) {
      tracer_.counts_->addRays(kind, generation_.bounces + 1, std::size_t(count));
    }
  }

  /// Traces the table, and adds to each sum what its rays bring, in their order.
  void flush() {
    if (next_.count == 0) return;
    const Arena::Frame frame(tracer_.arena_);
    HitTable hits(tracer_.arena_, next_.count);
    auto* colors = tracer_.arena_.take<Vec3f>(std::size_t(next_.count));
    tracer_.trace(next_, generation_.bounces + 1, hits, colors);
    for (int row = 0; row < next_.count; ++row) {
      surfaces_.add(next_.parent[row], Vec3d(next_.factor[row]) * Vec3d(colors[row]));
    }
    next_.count = 0;
  }

  WaveTracer& tracer_;
  const WaveGeneration& generation_;
  WaveSurfaces& surfaces_;
  WaveRays next_;
  // Of the surfaces at which rays follow: indices of refraction, and which rays are not mirrored
  // totally.
  double *before_, *behind_;
  std::uint16_t* places_;
};

WaveTracer::WaveTracer(const RayTracer& tracer, RayCounts* counts)
    : tracer_(tracer),
      rayByRay_(tracer.geometry()),
      batches_(dynamic_cast<const BatchGeometry*>(&tracer.geometry())),
      counts_(counts),
      kernels_(waveKernels(batches().simdLevel())),
      hasSources_(tracer.shader().options().epsilon.kind == Epsilon::Kind::adaptive) {}

void WaveTracer::trace(WaveRays& rays, int bounces, HitTable& hits, Vec3f* colors) {
  if (rays.count < kFewRays || bounces >= kMostGenerations) {
    return traceOneByOne(rays, bounces, hits, colors);
  }
  if (counts_ && bounces == 0) counts_->addRays(RayKind::eye, 0, std::size_t(rays.count));
  const Arena::Frame frame(arena_);
  const WaveGeneration generation = {rays, hits, meet(rays, hits), bounces};
  WaveHit* met = arena_.take<WaveHit>(std::size_t(RayTable::kMost));
  Vec3d* mixtures = nullptr;  // the sums of textures' components, for each ray
  SolidTexture::Mixture mixture;
  const Background& background = tracer_.scene().getBackground();
  const Material* last = nullptr;
  const SolidTexture* texture = nullptr;  // the same, if it is one
  int count = 0;
  const auto add = [&](int row, const WeightedMaterial& weighted, bool isComponent) {
    if (count == RayTable::kMost) {
      shade(generation, met, count, colors, mixtures);
      count = 0;
    }
    met[count++] = {std::uint16_t(row), 0, isComponent, weighted.material, weighted.weight};
  };
  for (int row = 0; row < rays.count; ++row) {
    if (!hits.isFound(row)) {
      colors[row] = background.colorAt(rowOf(rays.direction, row));
      continue;
    }
    if (hits.material[row] != last) texture = (last = hits.material[row])->asTexture();
    if (texture) {
      if (!mixtures) {
        mixtures = arena_.take<Vec3d>(std::size_t(rays.count));
        std::fill(mixtures, mixtures + rays.count, Vec3d());
      }
      for (const WeightedMaterial& component : texture->mixAt(rowOf(hits.point, row), mixture)) {
        add(row, component, true);
      }
    } else {
      add(row, {last, 1}, false);
    }
  }
  shade(generation, met, count, colors, mixtures);
}

void WaveTracer::traceOneByOne(const WaveRays& rays, int bounces, HitTable& hits, Vec3f* colors) {
  for (int row = 0; row < rays.count; ++row) {
    Ray ray = rays.rayOf(row);
    Hit hit;
    colors[row] = tracer_.traceRay(ray, float(rays.tmin[row]), bounces, rays.weight[row],
                                   rays.indexOf(row), hit);
    if (!hit.getMaterial()) continue;
    rays.tmax[row] = hit.getT();
    hits.setRow(row, hit, 0);
  }
}

void WaveTracer::intersect(WaveRays& eyeRays, HitTable& hits) {
  const Arena::Frame frame(arena_);
  if (counts_) counts_->addRays(RayKind::eye, 0, std::size_t(eyeRays.count));
  meet(eyeRays, hits);
}

/// Finds what the rays meet, and what lies on both sides of it; null where all of that is plain.
const Interface* WaveTracer::meet(WaveRays& rays, HitTable& hits) {
  Interface* found = nullptr;
  const Interfaces& interfaces = tracer_.interfaces();
  if (interfaces.arePlain()) {
    batches().intersectAll(rays, hits, arena_);
  } else {
    found = arena_.take<Interface>(std::size_t(rays.count));
    std::fill(found, found + rays.count, Interface());
    interfaces.intersectAll(batches(), rays, hits, found, arena_);
  }
  if (counts_) {
    const auto* order = hits.order;
    counts_->addMisses(std::size_t(std::count(order, order + rays.count, NearestSoFar::kNothing)));
  }
  return found;
}

/// RayTracer::shade for many surfaces, none of a texture. Every sum grows in the same order: the
/// ambient term may follow the lights, as a + l is l + a to the last bit.
void WaveTracer::shade(const WaveGeneration& generation, WaveHit* met, int count, Vec3f* colors,
                       Vec3d* mixtures) {
  if (count == 0) return;
  const Arena::Frame frame(arena_);
  WaveSurfaces surfaces(generation.rays, met, count, arena_);
  kernels_.takeSurfaces(generation.rays, generation.hits, surfaces);
  setEpsilons(generation, surfaces);
  setSides(surfaces);
  for (int light = 0; light < tracer_.scene().getNumLights(); ++light) {
    addLight(light, generation, surfaces);
  }
  for (int g = 0; g < surfaces.groupCount; ++g) {
    addAmbient(surfaces.groups[g], generation, surfaces);
  }
  Branches(*this, generation, surfaces).addAll();
  for (const WaveHit* hit = met; hit != met + count; ++hit) {
    Vec3d sum = rowOf(surfaces.sum, hit->place);
    if (generation.interfaces) sum *= Vec3d(generation.interfaces[hit->ray].tint);
    colors[hit->ray] = Vec3f(sum);
    if (!hit->isComponent) continue;
    mixtures[hit->ray] += hit->share * Vec3d(colors[hit->ray]);
    colors[hit->ray] = Vec3f(mixtures[hit->ray]);
  }
}

/// Adds the ambient term to the surfaces of a group, which have one for all where no map gives
/// their colours.
void WaveTracer::addAmbient(const MaterialGroup& group, const WaveGeneration& generation,
                            const WaveSurfaces& surfaces) const {
  const Shader& shader = tracer_.shader();
  const bool isMapped = shader.ambientMap(*group.material) != nullptr;
  Vec3d ambient = isMapped ? Vec3d() : shader.ambient(*group.material, Hit());
  if (!isMapped && !shader.hasBlackSides()) {
    for (int axis = 0; axis < 3; ++axis) {
      double *const sum = surfaces.sum[axis], added = ambient[axis];
      for (int k = group.first; k < group.last; ++k) sum[k] += added;
    }
    return;
  }
  for (int k = group.first; k < group.last; ++k) {
    if (shader.hasBlackSides() && rowOf(surfaces.lit, k) == Vec3d()) continue;
    if (isMapped) ambient = shader.ambient(*group.material, generation.hitOf(surfaces.ray[k]));
    surfaces.add(k, ambient);
  }
}

/// Sets from which t on the rays that leave look for surfaces.
void WaveTracer::setEpsilons(const WaveGeneration& generation, WaveSurfaces& surfaces) const {
  for (int k = 0; k < surfaces.count; ++k) {
    const double magnitude = generation.hits.magnitude[surfaces.ray[k]];
    surfaces.tmin[k] = double(tracer_.shader().epsilonAt(magnitude));
  }
}

/// Sets which side lights see: none, a normal of 0, where it is dark.
void WaveTracer::setSides(WaveSurfaces& surfaces) {
  const Shader& shader = tracer_.shader();
  if (!shader.options().shadeBack && !shader.hasDarkSides()) return;
  for (double*& column : surfaces.lit) column = arena_.take<double>(std::size_t(surfaces.count));
  for (int k = 0; k < surfaces.count; ++k) {
    const Vec3d normal = rowOf(surfaces.normal, k);
    setRowOf(surfaces.lit, k, shader.litNormal(normal, dot(normal, rowOf(surfaces.view, k))));
  }
}
