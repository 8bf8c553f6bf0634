// Reading OBJ meshes: the statements v and f; all others are passed over.
#pragma once
#include "geometry/mesh_geometry.h"
#include "scene/mistake_log.h"
#include "scene/source_text.h"

/// The vertices and triangles in `text`; faces of more corners become fans around their first.
/// Mistakes go to `log` with the OBJ file's name and line, at `place` in the scene file; where
/// there are any (and the log does not throw) the mesh is empty.
MeshGeometry readObj(const SourceText& text, MistakeLog& log, std::size_t place);
