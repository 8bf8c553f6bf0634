// NamedFiles: from a name in a scene to a file that has been read.
//
// A name is looked for beside the scene, then from the current folder, and at last, without its own
// folders, beside the scene again: scenes that were moved keep working. The first file that is
// there and can be read is taken; what was found out is kept, by name, so that a million objects
// with one mesh look for it once, and a missing one is told once.
//
// Names that lead to one file share what was read of it. What is broken is kept as that, so that
// its mistakes are told once too.
#include "scene/named_files.h"

#include <algorithm>
#include <filesystem>

#include "image/picture_file.h"
#include "scene/obj_reader.h"
#include "scene/wording.h"
#include "system/worker_threads.h"

namespace {

constexpr std::size_t kShownPath = 200;
constexpr std::size_t kLongestPath = 4096;  // no system finds a file of a longer name

/// A name without the quotes around it, in which \" stands for a quote.
std::string unquoted(std::string_view name) {
  if (name.size() < 2 || name[0] != '"') return std::string(name);
  std::string text;
  for (std::size_t k = 1; k + 1 < name.size(); ++k) {
    if (name[k] == '\\' && name[k + 1] == '"') ++k;
    text += name[k];
  }
  return text;
}

}  // namespace

std::size_t NamedFiles::find(std::string_view name, const char* at, const Reader& read) {
  auto known = byName_.find(name);
  if (known == byName_.end()) known = byName_.emplace(name, locate(name, at, read)).first;
  return known->second.empty() ? kBroken : byPath_[known->second];
}

bool NamedFiles::exists(std::string_view name) const {
  const std::vector<std::string> paths = candidates(name);
  return std::any_of(paths.begin(), paths.end(), [](const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
  });
}

std::vector<std::string> NamedFiles::paths() const {
  std::vector<std::string> paths;
  for (const auto& [name, path] : byName_) {
    if (!path.empty()) paths.push_back(path);
  }
  return paths;
}

void NamedFiles::report(const char* at, const std::string& message) const {
  log_.add(scene_.offsetOf(at), InputError(scene_.name(), scene_.lineAt(at), message));
}

/// The path without links by which the file is known, or "" after a report of all that was tried.
std::string NamedFiles::locate(std::string_view name, const char* at, const Reader& read) {
  std::string tried;
  for (const std::string& path : candidates(name)) {
    std::error_code error;
    std::string key = std::filesystem::canonical(path, error).string();
    std::string reason = error.message();
    std::size_t number = kBroken;
    const bool isKnown = byPath_.count(key) > 0;
    if (isKnown || (!error && read(path, number, reason))) {
      if (!isKnown) byPath_[key] = number;
      return key;
    }
    tried += (tried.empty() ? "" : ", ") + quoted(path, kShownPath) + " (" + reason + ")";
  }
  const std::string why = name.size() > kLongestPath ? "a path has at most 4096 bytes"
                          : tried.empty()            ? "no file can have this name"
                                                     : "looked for " + tried;
  report(at, "cannot read the " + std::string(kind_) + " " + quoted(name) + "; " + why);
  return {};
}

/// In the order in which they are tried, each once. Scenes from Windows have backslashes.
std::vector<std::string> NamedFiles::candidates(std::string_view name) const {
  if (name.size() > kLongestPath || name.find('\0') != std::string_view::npos) return {};
  std::string text = unquoted(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  const std::filesystem::path file(text);
  const std::filesystem::path folder = std::filesystem::path(scene_.name()).parent_path();
  std::vector<std::string> paths;
  for (const auto& path : {folder / file, file, folder / file.filename()}) {
    const std::string candidate = path.string();
    if (std::find(paths.begin(), paths.end(), candidate) == paths.end()) {
      paths.push_back(candidate);
    }
  }
  return paths;
}

// Meshes.

const MeshGeometry* MeshLibrary::find(std::string_view name, bool& isNew) {
  isNew = false;
  const auto readNew = [&](const std::string& path, std::size_t& number, std::string& reason) {
    return isNew = read(path, name, number, reason);
  };
  const std::size_t number = files_.find(name, name.data(), readNew);
  return number == NamedFiles::kBroken ? nullptr : meshes_[number].get();
}

/// Reads a mesh fast where that can be done, else as one text, which tells mistakes: then it is
/// broken. What a mesh tells of its corners is read from one text too, as it is asked for seldom.
/// False, and a reason, where the file cannot be read.
bool MeshLibrary::read(const std::string& path, std::string_view name, std::size_t& number,
                       std::string& reason) {
  const std::size_t mistakesBefore = log_.count();
  warnings_.clear();
  MeshGeometry mesh;
  const ObjDetails details = {rules_.keepsTextureCoordinates, rules_.usesFileNormals};
  // Without faces it may be no OBJ file at all.
  if (details.any() || !readObjFile(path, {hardwareThreads()}, mesh) || mesh.faceCount() == 0) {
    std::string bytes;
    if (!readWholeFile(path, bytes, reason)) return false;
    mesh = readText(path, std::move(bytes), scene_.offsetOf(name.data()), details);
  }
  if (log_.count() > mistakesBefore) return true;
  const bool isFlat = rules_.meshNormals == MeshNormals::flat ||
                      mesh.getVertices().size() <= rules_.mostFlatVertices;
  if (!isFlat) makeSmooth(mesh, rules_.meshNormals);
  number = meshes_.size();
  meshes_.push_back(std::make_unique<MeshGeometry>(std::move(mesh)));
  return true;
}

/// Lines may end in CR alone. What is no OBJ file at all is a mistake.
MeshGeometry MeshLibrary::readText(const std::string& path, std::string bytes, std::size_t place,
                                   const ObjDetails& details) {
  const auto reportKind = [&](const std::string& kind) {
    log_.add(place, InputError(path, 0, "expected an OBJ file, found what looks like " + kind));
    return MeshGeometry();
  };
  const std::string kind = otherKindOf(bytes);
  if (!kind.empty()) return reportKind(kind);
  if (bytes.find('\n') == bytes.npos) std::replace(bytes.begin(), bytes.end(), '\r', '\n');
  const std::size_t mistakesBefore = log_.count();
  const SourceText text(path, std::move(bytes));
  MeshGeometry mesh = readObj(text, log_, place, warnings_, details);
  const bool isNothing = mesh.getVertices().empty() && log_.count() == mistakesBefore;
  const bool hasNul = text.bytes().find('\0') != std::string_view::npos;  // as no text has
  return isNothing && hasNul ? reportKind("a binary file") : std::move(mesh);
}

// Pictures.

const ImageTexture* PictureLibrary::find(std::string_view name, const char* at) {
  // A picture that is there and broken is a mistake; another of its name is not looked for.
  const auto read = [&](const std::string& path, std::size_t& number, std::string&) {
    try {
      pictures_.push_back(std::make_unique<ImageTexture>(readImage(path)));
      number = pictures_.size() - 1;
    } catch (const ImageError& error) {
      files_.report(at, "cannot read the picture " + quoted(name) + "; " + error.what());
    }
    return true;
  };
  const std::size_t number = files_.find(name, at, read);
  return number == NamedFiles::kBroken ? nullptr : pictures_[number].get();
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
