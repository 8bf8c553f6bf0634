// NamedFiles: from a name in a scene to a file that has been read.
//
// A name is looked for beside the scene, then from the current folder, and at last, without its own
// folders, beside the scene again: scenes that were moved keep working. The first file that is
// there and can be read is taken; what was found out is kept, by name, so that a million objects
// with one mesh look for it once, and a missing one is told once.
#include "scene/named_files.h"

#include <algorithm>
#include <filesystem>

#include "scene/wording.h"

namespace {

constexpr std::size_t kShownPath = 200;
constexpr std::size_t kLongestPath = 4096;  // no system finds a file of a longer name

}  // namespace

/// In quotes, \" stands for a quote.
std::string unquoted(std::string_view name) {
  if (name.size() < 2 || name[0] != '"') return std::string(name);
  std::string text;
  for (std::size_t k = 1; k + 1 < name.size(); ++k) {
    if (name[k] == '\\' && name[k + 1] == '"') ++k;
    text += name[k];
  }
  return text;
}

const std::string& NamedFiles::find(std::string_view name, const char* at, const Reader& read) {
  const auto known = byName_.find(name);
  if (known != byName_.end()) return known->second;
  return byName_[std::string(name)] = locate(name, at, read);
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
  log_.add(std::size_t(at - scene_.bytes().data()),
           InputError(scene_.name(), scene_.lineAt(at), message));
}

/// The path without links by which the file is known, or "" after a report of all that was tried.
std::string NamedFiles::locate(std::string_view name, const char* at, const Reader& read) const {
  std::string tried;
  for (const std::string& path : candidates(name)) {
    std::error_code error;
    const std::string key = std::filesystem::canonical(path, error).string();
    std::string reason = error.message();
    if (!error && read(path, key, reason)) return key;
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
