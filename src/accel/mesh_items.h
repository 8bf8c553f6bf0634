// What the tree over a mesh is built of.
#pragma once
#include <cstdint>
#include <vector>

#include "accel/bvh_builder.h"
#include "accel/mesh_tree.h"
#include "accel/thread_pool.h"
#include "geometry/mesh_geometry.h"

namespace accel {

/// The boxes of all faces that have an area, by rising numbers, times `scale`. With `inPairs`
/// neighbours by number that share an edge are one item where one box for both is not larger than
/// the two together.
BuildItems meshItems(const MeshGeometry& geometry, float scale, bool inPairs, ThreadPool& pool);

/// Of all faces that have the same corners as one of `faces`, takes all but the first out of
/// `items`, which are as meshItems gives them, not in pairs. Returns those that have copies, sorted
/// by face.
std::vector<FaceCopies> dropCopies(const MeshGeometry& geometry,
                                   const std::vector<std::uint32_t>& faces, BuildItems& items);

}  // namespace accel
