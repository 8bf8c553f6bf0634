// NamedFiles: the files of one kind that a scene names, such as its meshes: where each is looked
// for, and which names mean the same one, so that it is read once.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "scene/input_error.h"
#include "scene/source_text.h"

class NamedFiles {
 public:
  /// Reads the file at `path`, which is there, unless that has been done: `key` is its path without
  /// links. False, and the reason, where it cannot be read.
  using Reader =
      std::function<bool(const std::string& path, const std::string& key, std::string& reason)>;

  /// Of `scene`, whose mistakes go to `log`; both must outlive this. `kind` is what messages call
  /// one of the files.
  NamedFiles(const SourceText& scene, MistakeLog& log, std::string_view kind)
      : scene_(scene), log_(log), kind_(kind) {}

  /// The path without links of the file that `name` means, read if need be: beside the scene file,
  /// in the current folder, or by the file's name alone beside the scene file. Quotes around the
  /// name are none of it, and backslashes stand for slashes. Empty where no file could be read,
  /// which is reported the first time, `at` being the place in the scene where it is named.
  const std::string& find(std::string_view name, const char* at, const Reader& read);
  /// Whether find() would find a file, be it one that can be read or not.
  bool exists(std::string_view name) const;

  /// The file of each name that find() has found, as an absolute path without links, in the
  /// alphabetical order of the names.
  std::vector<std::string> paths() const;

  /// Reports a mistake where the file is named.
  void report(const char* at, const std::string& message) const;

 private:
  std::vector<std::string> candidates(std::string_view name) const;
  std::string locate(std::string_view name, const char* at, const Reader& read) const;

  const SourceText& scene_;
  MistakeLog& log_;
  std::string_view kind_;
  std::map<std::string, std::string, std::less<>> byName_;  // paths without links
};

/// A name without the quotes around it, in which \" stands for a quote.
std::string unquoted(std::string_view name);
