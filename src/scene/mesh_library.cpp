// Finding and reading mesh files.
#include "scene/mesh_library.h"

#include <algorithm>
#include <filesystem>

#include "scene/obj_reader.h"
#include "scene/source_text.h"
#include "scene/wording.h"
#include "system/worker_threads.h"

namespace {

constexpr std::size_t kShownPath = 200;
constexpr std::size_t kLongestPath = 4096;  // no system finds a file of a longer name

/// The file's one true path; empty, and a reason, where there is no such file.
std::string resolved(const std::string& path, std::string& reason) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::canonical(path, error);
  if (error) reason = error.message();
  return error ? std::string() : canonical.string();
}

}  // namespace

const MeshGeometry* MeshLibrary::find(std::string_view name, bool& isNew) {
  isNew = false;
  const auto known = byName_.find(name);
  if (known != byName_.end()) return known->second;
  return byName_[name] = load(name, isNew);
}

std::vector<std::string> MeshLibrary::files() const {
  std::map<const MeshGeometry*, std::string> paths;
  for (const auto& [path, mesh] : byPath_) paths[mesh] = path;
  std::vector<std::string> files;
  for (const auto& [name, mesh] : byName_) {
    if (mesh) files.push_back(paths[mesh]);
  }
  return files;
}

const MeshGeometry* MeshLibrary::load(std::string_view name, bool& isNew) {
  const std::size_t place = std::size_t(name.data() - scene_.bytes().data());
  std::string tried;
  for (const std::string& path : candidates(name)) {
    std::string bytes, reason;
    const std::string key = resolved(path, reason);
    const auto known = byPath_.find(key);
    if (known != byPath_.end()) return known->second;
    MeshGeometry mesh;
    isNew = !key.empty();
    if (isNew && readObjFile(path, {hardwareThreads()}, mesh)) {
      return byPath_[key] = keep(std::move(mesh));
    }
    if (isNew && readWholeFile(path, bytes, reason)) {
      return byPath_[key] = read(path, std::move(bytes), place);
    }
    isNew = false;
    tried += (tried.empty() ? "" : ", ") + quoted(path, kShownPath) + " (" + reason + ")";
  }
  const std::string why = name.size() > kLongestPath ? "a path has at most 4096 bytes"
                          : tried.empty()            ? "no file can have this name"
                                                     : "looked for " + tried;
  log_.add(place, InputError(scene_.name(), scene_.lineAt(name.data()),
                             "cannot read the mesh " + quoted(name) + "; " + why));
  return nullptr;
}

const MeshGeometry* MeshLibrary::read(const std::string& path, std::string bytes,
                                      std::size_t place) {
  const std::size_t mistakesBefore = log_.count();
  const SourceText text(path, std::move(bytes));
  MeshGeometry mesh = readObj(text, log_, place);
  return log_.count() > mistakesBefore ? nullptr : keep(std::move(mesh));
}

const MeshGeometry* MeshLibrary::keep(MeshGeometry&& mesh) {
  meshes_.push_back(std::make_unique<MeshGeometry>(std::move(mesh)));
  return meshes_.back().get();
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
