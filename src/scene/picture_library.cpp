// PictureLibrary: reading pictures, and finding the six of a cube map.
#include "scene/picture_library.h"

#include "image/picture_file.h"
#include "scene/wording.h"

const ImageTexture* PictureLibrary::find(std::string_view name, const char* at) {
  // A picture that is there and broken is a mistake; another of its name is not looked for.
  const auto read = [&](const std::string& path, const std::string& key, std::string&) {
    if (byPath_.count(key) > 0) return true;
    const ImageTexture*& kept = byPath_[key];
    try {
      pictures_.push_back(std::make_unique<ImageTexture>(readImage(path)));
      kept = pictures_.back().get();
    } catch (const ImageError& error) {
      files_.report(at, "cannot read the picture " + quoted(name) + "; " + error.what());
    }
    return true;
  };
  const std::string& path = files_.find(name, at, read);
  return path.empty() ? nullptr : byPath_[path];
}

std::optional<CubeMap> PictureLibrary::findCube(std::string_view folder, std::string_view ending) {
  CubeMap::Pictures faces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const std::string start = unquoted(folder) + "/" + std::string(CubeMap::kFaces[i]) + ".";
    std::string name = start + std::string(ending);
    for (const char* const other : kPictureEndings) {
      if (!files_.exists(name) && files_.exists(start + other)) name = start + other;
    }
    faces[i] = find(name, folder.data());
    if (!faces[i]) return std::nullopt;
  }
  return CubeMap(faces);
}
