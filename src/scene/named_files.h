// NamedFiles: the files of one kind that a scene names: where each is looked for, and which names
// mean the same one, so that it is read once. MeshLibrary and PictureLibrary: what is read of them.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh_geometry.h"
#include "scene/input_error.h"
#include "scene/scene_rules.h"
#include "scene/source_text.h"
#include "shading/background.h"
#include "shading/diffuse_map.h"

struct ObjDetails;

class NamedFiles {
 public:
  /// Reads the file at `path`, which is there. True where it can be read: then `number` becomes
  /// what the caller knows its contents by, or stays kBroken. False, and the reason, where it
  /// cannot.
  using Reader =
      std::function<bool(const std::string& path, std::size_t& number, std::string& reason)>;
  static constexpr std::size_t kBroken = std::size_t(-1);

  /// Of `scene`, whose mistakes go to `log`; both must outlive this. `kind` is what messages call
  /// one of the files.
  NamedFiles(const SourceText& scene, MistakeLog& log, std::string_view kind)
      : scene_(scene), log_(log), kind_(kind) {}

  /// The number of the file that `name` means, read if need be: beside the scene file, in the
  /// current folder, or by the file's name alone beside the scene file. Quotes around the name are
  /// none of it, and backslashes stand for slashes. kBroken where there was a mistake; that no file
  /// could be read is reported the first time, `at` being the place in the scene where it is named.
  std::size_t find(std::string_view name, const char* at, const Reader& read);
  /// Whether find() would find a file, be it one that can be read or not.
  bool exists(std::string_view name) const;

  /// The file of each name that find() has found, as an absolute path without links, in the
  /// alphabetical order of the names.
  std::vector<std::string> paths() const;

  /// Reports a mistake where the file is named.
  void report(const char* at, const std::string& message) const;

 private:
  std::vector<std::string> candidates(std::string_view name) const;
  std::string locate(std::string_view name, const char* at, const Reader& read);

  const SourceText& scene_;
  MistakeLog& log_;
  std::string_view kind_;
  std::map<std::string, std::string, std::less<>> byName_;  // paths without links
  std::map<std::string, std::size_t> byPath_;               // numbers
};

/// The meshes that a scene names, each file read once.
class MeshLibrary {
 public:
  /// Reads on behalf of `scene` into `meshes`, as `rules` say; all but these must outlive the
  /// library.
  MeshLibrary(const SourceText& scene, MistakeLog& log,
              std::vector<std::unique_ptr<MeshGeometry>>& meshes, const SceneRules& rules)
      : scene_(scene), log_(log), files_(scene, log, "mesh"), meshes_(meshes), rules_(rules) {}

  /// The mesh that the scene calls `name` (a view into the scene's bytes), read if need be; see
  /// NamedFiles. Null where there were mistakes, which are reported the first time. `isNew` tells
  /// whether the file was read just now. Not owned by the caller.
  const MeshGeometry* find(std::string_view name, bool& isNew);
  /// What is to be said of the mesh that find() has read last.
  const std::vector<std::string>& warnings() const { return warnings_; }

  const NamedFiles& files() const { return files_; }

 private:
  bool read(const std::string& path, std::string_view name, std::size_t& number,
            std::string& reason);
  MeshGeometry readText(const std::string& path, std::string bytes, std::size_t place,
                        const ObjDetails& details);

  const SourceText& scene_;
  MistakeLog& log_;
  NamedFiles files_;
  std::vector<std::unique_ptr<MeshGeometry>>& meshes_;
  const SceneRules rules_;
  std::vector<std::string> warnings_;
};

/// The pictures that a scene names, for textures and cube maps: in any format that image/ reads,
/// each file once.
class PictureLibrary {
 public:
  /// Reads on behalf of `scene` into `pictures`; both, and `log`, must outlive the library.
  PictureLibrary(const SourceText& scene, MistakeLog& log,
                 std::vector<std::unique_ptr<ImageTexture>>& pictures)
      : files_(scene, log, "picture"), pictures_(pictures) {}

  /// The picture that the scene, at `at`, calls `name`; see NamedFiles. Null where there was a
  /// mistake, which is reported the first time. Not owned by the caller.
  const ImageTexture* find(std::string_view name, const char* at);
  const ImageTexture* find(std::string_view name) { return find(name, name.data()); }
  /// Of the six pictures in a folder that the scene calls `folder` (a view into its bytes):
  /// "left.bmp" and so on, for CubeMap::kFaces. Where there is no file with `ending`, one with that
  /// of another format is taken, kPictureEndings. std::nullopt after a mistake.
  std::optional<CubeMap> findCube(std::string_view folder, std::string_view ending);

  const NamedFiles& files() const { return files_; }

 private:
  NamedFiles files_;
  std::vector<std::unique_ptr<ImageTexture>>& pictures_;
};
