// Finding and reading the mesh files that a scene names.

#include <algorithm>
#include <filesystem>

#include "scene/obj_reader.h"
#include "scene/scene_reader.h"
#include "scene/source_text.h"
#include "scene/wording.h"
#include "system/worker_threads.h"

namespace {

constexpr std::size_t kShownPath = 200;
constexpr std::size_t kLongestPath = 4096;  // no system finds a file of a longer name

}  // namespace

const MeshGeometry* MeshLibrary::find(std::string_view name, bool& isNew) {
  isNew = false;
  if (byName_.count(name) == 0) byName_[name] = locate(name, isNew);
  const std::string& path = byName_[name];
  return path.empty() ? nullptr : byPath_[path];
}

std::vector<std::string> MeshLibrary::files() const {
  std::vector<std::string> files;
  for (const auto& [name, path] : byName_) {
    if (!path.empty() && byPath_.at(path)) files.push_back(path);
  }
  return files;
}

/// The path without links of the file that `name` means, which has then been read; empty where
/// there is none that can be read.
std::string MeshLibrary::locate(std::string_view name, bool& isNew) {
  std::string tried;
  for (const std::string& path : candidates(name)) {
    std::error_code error;
    const std::string key = std::filesystem::canonical(path, error).string();
    std::string reason = error.message();
    if (!error && byPath_.count(key) > 0) return key;
    isNew = !error && read(path, key, name, reason);
    if (isNew) return key;
    tried += (tried.empty() ? "" : ", ") + quoted(path, kShownPath) + " (" + reason + ")";
  }
  const std::string why = name.size() > kLongestPath ? "a path has at most 4096 bytes"
                          : tried.empty()            ? "no file can have this name"
                                                     : "looked for " + tried;
  log_.add(placeOf(name), InputError(scene_.name(), scene_.lineAt(name.data()),
                                     "cannot read the mesh " + quoted(name) + "; " + why));
  return {};
}

/// Reads a mesh fast where that can be done, else as one text, which tells mistakes: then null is
/// kept in its place. False, and a reason, where the file cannot be read.
bool MeshLibrary::read(const std::string& path, const std::string& key, std::string_view name,
                       std::string& reason) {
  const std::size_t mistakesBefore = log_.count();
  MeshGeometry mesh;
  if (!readObjFile(path, {hardwareThreads()}, mesh)) {
    std::string bytes;
    if (!readWholeFile(path, bytes, reason)) return false;
    mesh = readObj(SourceText(path, std::move(bytes)), log_, placeOf(name));
  }
  const MeshGeometry*& kept = byPath_[key];
  if (log_.count() > mistakesBefore) return true;
  meshes_.push_back(std::make_unique<MeshGeometry>(std::move(mesh)));
  kept = meshes_.back().get();
  return true;
}

std::vector<std::string> MeshLibrary::candidates(std::string_view name) const {
  if (name.size() > kLongestPath || name.find('\0') != std::string_view::npos) return {};
  std::string text(name);
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
