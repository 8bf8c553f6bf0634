// MeshLibrary: finds the mesh files that a scene names and reads each of them once.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_geometry.h"
#include "scene/input_error.h"
#include "scene/source_text.h"

class MeshLibrary {
 public:
  /// Reads on behalf of `scene` into `meshes`; both, and `log`, must outlive the library.
  MeshLibrary(const SourceText& scene, MistakeLog& log,
              std::vector<std::unique_ptr<MeshGeometry>>& meshes)
      : scene_(scene), log_(log), meshes_(meshes) {}

  /// The mesh that the scene calls `name` (a view into the scene's bytes), read if need be: beside
  /// the scene file, in the current folder, or by its last part alone beside the scene file. Null
  /// where there were mistakes, which are reported the first time. `isNew` tells whether the file
  /// was read just now. Not owned by the caller.
  const MeshGeometry* find(std::string_view name, bool& isNew);

  /// The file of each name that find() has found, as an absolute path without links, in the
  /// alphabetical order of the names.
  std::vector<std::string> files() const;

 private:
  const MeshGeometry* load(std::string_view name, bool& isNew);
  const MeshGeometry* read(const std::string& path, std::string bytes, std::size_t place);
  const MeshGeometry* keep(MeshGeometry&& mesh);
  std::vector<std::string> candidates(std::string_view name) const;

  const SourceText& scene_;
  MistakeLog& log_;
  std::vector<std::unique_ptr<MeshGeometry>>& meshes_;
  std::map<std::string_view, const MeshGeometry*> byName_;  // as the scene writes it
  std::map<std::string, const MeshGeometry*> byPath_;       // with links and dots resolved
};
