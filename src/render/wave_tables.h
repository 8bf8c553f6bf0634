// The tables of a wave: a generation of rays, the surfaces that they meet, and the light that
// comes to these. All memory is an Arena's; nothing is owned.
#pragma once
#include <cstdint>

#include "geometry/ray_table.h"
#include "render/interfaces.h"
#include "render/transmittance.h"

/// Rays that have made the same number of bounces. Row i continues surface parent[i] of the
/// generation before; an eye ray continues none.
struct WaveRays : RayTable {
  float* weight;  ///< the share that the ray's colour has in the pixel
  Vec3f* factor;  ///< of its colour in that of the surface
  std::uint16_t* parent;
  float* index = nullptr;  ///< of refraction, of the medium it travels in; null: 1 for all

  /// Room for `rows` rays, none of which is there yet.
  WaveRays(Arena& arena, int rows, bool hasSources, bool hasIndices = false);

  float indexOf(int row) const { return index ? index[row] : 1; }
};

/// A table of rays, and what they have met.
struct WaveGeneration {
  const WaveRays& rays;
  const HitTable& hits;
  const Interface* interfaces;  ///< of each ray; null where all are plain
  int bounces;

  /// What ray `row` has met; see HitTable::hitOf.
  Hit hitOf(int row) const { return hits.hitOf(row, rays.tmax[row]); }
  /// On both sides of what ray `row` has met; `approach` is n.v.
  const Interface& interfaceOf(int row, double approach) const {
    return interfaces ? interfaces[row] : Interfaces::plainInterface(approach);
  }
};

/// A surface in the order of the rays: a hit, or one component of it where a texture was hit.
struct WaveHit {
  std::uint16_t ray;         ///< the row of the ray
  std::uint16_t place;       ///< of the surface in WaveSurfaces
  bool isComponent;          ///< of a texture
  const Material* material;  ///< not a texture
  double share;              ///< in the ray's colour: 1 but for a component
};

/// Surfaces [first, last) are of one material.
struct MaterialGroup {
  const Material* material;
  int first, last;
};

/// Surfaces, those of one material side by side as a rule, groups in the order of their first
/// surface.
struct WaveSurfaces {
  int count;
  MaterialGroup* groups;
  int groupCount = 0;

  std::uint16_t* ray;  ///< the row of the ray that met it
  double* view[3];     ///< direction of that ray, unit
  double* point[3];
  double* normal[3];  ///< unit; its side is the surface's own
  double* lit[3];     ///< the normal on the side that lights see
  double* tmin;       ///< epsilon, for rays that leave
  float* weight;      ///< of the colour in the pixel
  double* sum[3];     ///< the colour so far, but for Interface::tint

  /// Sorts `count` hits, whose places it sets. `view`, `point`, `normal`, `tmin` and `sum` are
  /// still to be filled; `lit` is `normal`.
  WaveSurfaces(const WaveRays& rays, WaveHit* met, int count, Arena& arena);

  void add(int row, const Vec3d& color) const {
    for (int axis = 0; axis < 3; ++axis) sum[axis][row] += color[axis];
  }

 private:
  void makeGroups(const WaveHit* met, std::uint16_t* groupOf);
};

/// The shadow rays to one light, from the surfaces that are turned towards it, and what arrives.
struct WaveLight : RayTable {
  std::uint16_t* surface;  ///< row i comes from surface[i]; they ascend
  double* color[3];        ///< what arrives where nothing is in the way; each a float

  /// Room for `rows` rays, none of which is there yet.
  WaveLight(Arena& arena, int rows, bool hasSources);
};

/// Filters in the ways of rays.
struct ColorFilterTable {
  int count = 0;
  std::uint16_t* row;  ///< of the ray; those of a ray stand together
  double* color[3];    ///< each a float
  double* exponent;

  /// Room for `rows` filters, none of which is there yet.
  ColorFilterTable(Arena& arena, int rows);
  void add(const ColorFilter& filter, int ofRow);
};
