// PictureLibrary: the pictures that a scene names, for textures and cube maps. They are read by the
// readers of image/, in any format, and each file once.
#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/named_files.h"
#include "shading/background.h"
#include "shading/diffuse_map.h"

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
  std::map<std::string, const ImageTexture*> byPath_;  // null for one that is broken
};
