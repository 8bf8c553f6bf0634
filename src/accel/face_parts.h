// Slanting faces of a mesh, divided into parts before its tree is built.
#pragma once
#include "accel/bvh_builder.h"
#include "accel/thread_pool.h"
#include "geometry/mesh_geometry.h"

namespace accel {

/// Where boxes of `items`, as meshItems gives them for `geometry` and `scale`, lie over one another
/// so much that it pays: puts several items in place of each that slants, of the same faces but
/// each with a box around a part of them, so that every point of a face is in one of its boxes.
/// There are at most kMostParts times as many items then, and no part is shorter, along the longest
/// side of its box, than 1 / kFinest of the mesh. True if any was divided. The outcome does not
/// depend on the number of threads.
bool divideIntoParts(const MeshGeometry& geometry, float scale, BuildItems& items,
                     ThreadPool& pool);

/// Longer than what begins a frame (stream.h): frames hold whole faces, as error bounds there want.
constexpr int kMostParts = 4, kFinest = 256;

}  // namespace accel
