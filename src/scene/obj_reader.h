// Reading OBJ meshes: the statements v and f; all others are passed over.
#pragma once
#include <string>

#include "geometry/mesh_geometry.h"
#include "scene/mistake_log.h"
#include "scene/source_text.h"

/// How a file is read: what comes out does not depend on it.
struct ObjReading {
  int threads = 1;
  std::size_t chunkBytes = std::size_t(256) << 10;  // what a thread reads at a time; > 0
};

/// Reads a regular file by several threads into `mesh`. Returns false, and leaves `mesh` as it
/// was, for any other kind of file, and where anything is wrong: readObj then says what.
bool readObjFile(const std::string& filename, const ObjReading& how, MeshGeometry& mesh);

/// The vertices and triangles in `text`; faces of more corners become fans around their first.
/// Mistakes go to `log` with the OBJ file's name and line, at `place` in the scene file; where
/// there are any (and the log does not throw) the mesh is empty.
MeshGeometry readObj(const SourceText& text, MistakeLog& log, std::size_t place);
