// What the tree over a mesh is built of.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/bvh_builder.h"
#include "accel/mesh_tree.h"
#include "accel/thread_pool.h"
#include "geometry/mesh_geometry.h"

namespace accel {

struct MeshItems {
  BuildItems items;
  double halfAreas;  ///< of all their boxes together
};

/// The boxes of all faces that have an area, by rising numbers, times `scale`. Neighbours by number
/// that share an edge are one item where one box for both is not larger than the two together.
MeshItems meshItems(const MeshGeometry& geometry, float scale, ThreadPool& pool);

/// Where boxes of `all`, as meshItems gives them for `geometry` and `scale`, lie over one another
/// so much that it pays: puts several items in place of each that slants, of the same faces but
/// each with a box around a part of them, so that every point of a face is in one of its boxes.
/// There are at most kMostParts times as many items then, and no part is shorter, along the longest
/// side of its box, than 1 / kFinest of the mesh. True if any was divided.
bool divideIntoParts(const MeshGeometry& geometry, float scale, MeshItems& all);

/// Longer than what begins a frame (stream.h): frames hold whole faces, as error bounds there want.
constexpr int kMostParts = 4, kFinest = 256;

/// Of each kind of items with the same box and corners that are too many for a leaf, keeps the one
/// of the first faces. Moves what is kept to the front and returns its number; appends the faces
/// that have copies.
std::size_t dropCopies(const MeshGeometry& geometry, BuildItem* items, std::size_t count,
                       std::vector<FaceCopies>& copies);

}  // namespace accel
