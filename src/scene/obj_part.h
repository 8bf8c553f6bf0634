// ObjPart: what a run of OBJ statements says, and the one reader of such statements.
// A file may be read as one part, or as many that know nothing of each other and are then joined.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_geometry.h"

/// Vertices and faces are numbered in 32 bits.
inline constexpr std::size_t kMaxObjParts = std::numeric_limits<std::uint32_t>::max();

struct ObjPart {
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces;  // faces of more corners are fans around their first
  std::uint64_t highest = 0;    ///< the largest index that was counted from the file's start
  std::uint64_t reachBack = 0;  ///< how many of the vertices before this part indices count back
  /// Corners (3 * face + corner) that were counted backwards: their indices count from the part's
  /// first vertex, modulo 2^32. Not kept where nothing stands before the part.
  std::vector<std::size_t> relativeCorners;

  /// Empties the part, but keeps its memory.
  void clear() {
    vertices.clear();
    faces.clear();
    highest = reachBack = 0;
    relativeCorners.clear();
  }
};

/// What the reader of a part takes for granted: indices up to `vertices` are right, and so is
/// counting back over `before` vertices that stand before the part.
struct ObjSurroundings {
  std::size_t vertices = kMaxObjParts;
  std::size_t before = kMaxObjParts;
};

/// Takes what is wrong, and the place in the statements where it stands. May throw.
using ObjReport = std::function<void(const char* at, const std::string& message)>;

/// Reads whole statements, appending to an empty `part`. After a mistake that `report` lets pass,
/// reading goes on with the next statement; the part then keeps its number of vertices only.
void readObjPart(std::string_view statements, const ObjSurroundings& around,
                 const ObjReport& report, ObjPart& part);

/// How many vertices the statements define.
std::size_t countObjVertices(std::string_view statements);
