// Pairs of pictures.
#include "cli/picture_pairs.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "image/bytes.h"

namespace {

namespace fs = std::filesystem;

bool isPictureName(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  for (const char* known : {".tga", ".png", ".ppm", ".pgm", ".pfm"}) {
    if (ending == known) return true;
  }
  return false;
}

std::string withoutEnding(const std::string& name) {
  return fs::path(name).replace_extension().string();
}

std::string inFolder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

}  // namespace

std::vector<std::string> picturesIn(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  while (!error && entry != fs::recursive_directory_iterator()) {
    std::error_code ignored;
    if (isPictureName(entry->path()) && !entry->is_directory(ignored)) {
      names.push_back(entry->path().lexically_relative(folder).string());
    }
    entry.increment(error);
  }
  if (error) throw ImageError(folder, error.message());
  std::sort(names.begin(), names.end());
  return names;
}

std::string partnerOf(const std::string& name, const std::vector<std::string>& pictures) {
  if (std::binary_search(pictures.begin(), pictures.end(), name)) return name;
  const auto found = std::find_if(pictures.begin(), pictures.end(), [&](const std::string& other) {
    return withoutEnding(other) == withoutEnding(name);
  });
  return found == pictures.end() ? "" : *found;
}

std::vector<PicturePair> pairsIn(const std::string& expectedFolder,
                                 const std::string& actualFolder) {
  const std::vector<std::string> expected = picturesIn(expectedFolder);
  const std::vector<std::string> actual = picturesIn(actualFolder);
  std::vector<PicturePair> pairs;
  std::set<std::string> taken;
  for (const std::string& name : expected) {
    const std::string partner = partnerOf(name, actual);
    taken.insert(partner);
    pairs.push_back({name, inFolder(expectedFolder, name),
                     partner.empty() ? "" : inFolder(actualFolder, partner)});
  }
  for (const std::string& name : actual) {
    if (taken.count(name) == 0) pairs.push_back({name, "", inFolder(actualFolder, name)});
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const PicturePair& a, const PicturePair& b) { return a.name < b.name; });
  return pairs;
}
