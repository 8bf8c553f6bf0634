// Reading OBJ meshes: the statements v and f, and where they are asked for vt and vn; all others
// are passed over. A face of more than three corners is a fan first (readObjChunk), and is cut into
// triangles that follow its outline when all vertices are known (cutOutline, geometry/polygon.h).
//
// A file is cut into chunks of whole statements, and several threads take them by turns. The reader
// of a chunk knows nothing of what stands before it: it takes for granted that there are enough
// vertices for every index, and counts indices that count backwards from the chunk's own first
// vertex. When all chunks are read, these guesses are checked, the backward indices are moved by
// the number of vertices before their chunk, and the chunks are put in a row. Where a guess was
// wrong, or anything else is, the text is read once more as one chunk, which can name every
// mistake.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_geometry.h"
#include "scene/input_error.h"
#include "scene/source_text.h"
#include "system/files.h"

/// How a file is read: what comes out does not depend on it.
struct ObjReading {
  int threads = 1;
  std::size_t chunkBytes = std::size_t(256) << 10;  // what a thread reads at a time; > 0
};

/// What is kept of a file beside vertices and faces, see MeshShading. Of what is not kept no
/// mistake is told.
struct ObjDetails {
  bool coordinates = false;  ///< vt u [v], and the b of a corner a/b/c
  bool normals = false;      ///< vn x y z, and its c

  bool any() const { return coordinates || normals; }
};

/// Reads a regular file by several threads into `mesh`. Returns false, and leaves `mesh` as it
/// was, for any other kind of file, and where anything is wrong or to be warned of: readObj then
/// says what.
bool readObjFile(const std::string& filename, const ObjReading& how, MeshGeometry& mesh);

/// The vertices and triangles in `text`; faces of more corners are cut into triangles: convex ones,
/// and those that cross themselves, into a fan around their first. Faces of fewer corners are left
/// out. Mistakes go to `log` with the OBJ file's name and line, at `place` in the scene file; where
/// there are any (and the log does not throw) the mesh is empty. What is legal, but not as it seems
/// to be meant, is said in `warnings`, each ending in the line.
MeshGeometry readObj(const SourceText& text, MistakeLog& log, std::size_t place,
                     std::vector<std::string>& warnings, const ObjDetails& details = {});

// The steps of reading, for their sources and tests.

/// Vertices and faces are numbered in 32 bits.
inline constexpr std::size_t kMostObjElements = std::numeric_limits<std::uint32_t>::max();

/// A face of more than three corners: triangles of the chunk, later of the mesh, in a row.
struct ObjPolygon {
  std::size_t at;  ///< the place of its statement, from the chunk's first byte on
  std::uint32_t first, triangles;
};

/// What a run of statements says.
struct ObjChunk {
  std::vector<Vec3f> vertices;
  std::vector<MeshGeometry::Face> faces;  // polygons are fans around their first corner
  std::vector<ObjPolygon> polygons;
  std::vector<std::size_t> slivers;  ///< the places of faces of one or two corners, left out
  std::uint64_t highest = 0;         ///< the largest index that was counted from the file's start
  std::uint64_t reachBack = 0;  ///< how many of the vertices before this chunk indices count back
  /// Corners (3 * face + corner) that were counted backwards: their indices count from the chunk's
  /// first vertex, modulo 2^32. Not kept where nothing stands before the chunk.
  std::vector<std::size_t> relativeCorners;
  MeshShading shading;  ///< what details were wanted; its faces are cut as `faces` are

  /// Empties the chunk, but keeps its memory.
  void clear() {
    vertices.clear();
    faces.clear();
    polygons.clear();
    slivers.clear();
    highest = reachBack = 0;
    relativeCorners.clear();
  }
};

/// What the reader of a chunk takes for granted: indices up to `vertices` are right, and so is
/// counting back over `before` vertices that stand before the chunk.
struct ObjSurroundings {
  std::size_t vertices = kMostObjElements;
  std::size_t before = kMostObjElements;
};

/// Takes what is wrong, and the place in the statements where it stands. May throw.
using ObjReport = std::function<void(const char* at, const std::string& message)>;

/// Reads whole statements, appending to an empty `chunk`. After a mistake that `report` lets pass,
/// reading goes on with the next statement; the chunk then keeps its number of vertices only.
/// Where details are wanted, the statements must be the whole file.
void readObjChunk(std::string_view statements, const ObjSurroundings& around,
                  const ObjReport& report, ObjChunk& chunk, const ObjDetails& details = {});

/// How many statements begin with the word `name`, such as v.
std::size_t countObjStatements(std::string_view statements, std::string_view name);

/// Appends the place of each vertex that the statements define, in double; anything where there is
/// a mistake.
void readObjPlaces(std::string_view statements, std::vector<Vec3d>& places);

/// True where the faces' box is further from 0 than 16 times its longest side: the largest
/// coordinate, by size, of the point of the box that is nearest to 0. Of most meshes few faces are
/// looked at.
bool isFarMesh(const std::vector<Vec3f>& vertices, const std::vector<MeshGeometry::Face>& faces);

/// Measures vertices, of which all faces' have places, anew from an origin amid them. Returns that:
/// a MeshGeometry's.
Vec3d measureFromMiddle(const std::vector<Vec3d>& places,
                        const std::vector<MeshGeometry::Face>& faces, std::vector<Vec3f>& vertices);

/// The statements that begin in chunk `number` (0, 1, ...) of an open file, each chunk being
/// `chunkBytes` >= 1 long; the last of them may end behind it. A view of `buffer`, empty where none
/// begins there; std::nullopt where the file cannot be read. A byte-order mark at the file's start
/// is left out. Together the chunks are the file.
std::optional<std::string_view> readStatements(const OpenFile& file, std::size_t number,
                                               std::size_t chunkBytes, std::vector<char>& buffer);
