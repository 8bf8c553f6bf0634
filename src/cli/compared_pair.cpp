// ComparedPair: which pictures belong together, and comparing them.
//
// Pictures of two folders are paired by their paths below them. Endings may differ, so that a TGA
// can be compared with the PNG it was converted to; a path that is the same with its ending goes
// first.
#include "cli/compared_pair.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "image/picture_file.h"

namespace {

namespace fs = std::filesystem;
using Result = ComparedPair::Result;

/// By the ending alone: a file that is no picture in spite of it is unreadable, and so told.
bool isPictureName(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) {
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  }
  for (const char* known : {".tga", ".png", ".ppm", ".pgm", ".pfm"}) {
    if (ending == known) return true;
  }
  return false;
}

/// out/a.tga is out/a.
fs::path withoutEnding(const std::string& name) { return fs::path(name).replace_extension(); }

std::string sizeText(const Image& image) {
  return std::to_string(image.Width()) + " x " + std::to_string(image.Height());
}

/// As PNG, in which they go into the report: it holds those of all pairs at once, and their pixels
/// would take more memory.
void keepPictures(const Image& expected, const Image& actual, ComparedPair& pair) {
  pair.expectedPng = encodePicture(expected, PictureFormat::png);
  if (pair.comparison && pair.comparison->maximum == 0) return;
  pair.actualPng = encodePicture(actual, PictureFormat::png);
  pair.differencePng = encodePicture(differencePicture(expected, actual), PictureFormat::png);
}

/// Greater is worse.
auto badnessOf(const ComparedPair& pair) {
  const int kind = pair.result == Result::same ? 0 : pair.result == Result::different ? 1 : 2;
  const bool otherSize = !pair.comparison && !pair.isAtFault();
  return std::make_tuple(kind, otherSize, pair.comparison ? pair.comparison->percentOver() : 0.0,
                         pair.comparison ? pair.comparison->rms : 0.0);
}

}  // namespace

void ComparedPair::fail(Result how, const std::string& why) {
  result = how;
  fault = why;
}

const char* nameOf(Result result) {
  static constexpr const char* kNames[] = {"same", "different", "missing", "unexpected",
                                           "unreadable"};
  return kNames[int(result)];
}

std::string inFolder(const std::string& folder, const std::string& name) {
  return name.empty() ? "" : (fs::path(folder) / name).string();
}

/// The order of a folder is the file system's own; sorted, it is the same everywhere.
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

/// Two expected pictures may have the same partner, for example a TGA and a PNG of one name.
std::vector<ComparedPair> pairsIn(const std::string& expectedFolder,
                                  const std::string& actualFolder) {
  const std::vector<std::string> expected = picturesIn(expectedFolder);
  const std::vector<std::string> actual = picturesIn(actualFolder);
  std::vector<ComparedPair> pairs;
  std::set<std::string> taken;
  for (const std::string& name : expected) {
    const std::string partner = partnerOf(name, actual);
    pairs.push_back({name, inFolder(expectedFolder, name), inFolder(actualFolder, partner)});
    taken.insert(partner);
    if (!partner.empty()) continue;
    pairs.back().fail(Result::missing, "no actual picture");
  }
  for (const std::string& name : actual) {
    if (taken.count(name) > 0) continue;
    pairs.push_back({name, "", inFolder(actualFolder, name)});
    pairs.back().fail(Result::unexpected, "no expected picture");
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const ComparedPair& a, const ComparedPair& b) { return a.name < b.name; });
  return pairs;
}

bool isWorse(const ComparedPair& a, const ComparedPair& b) {
  const auto p = badnessOf(a), q = badnessOf(b);
  return p != q ? p > q : a.name < b.name;
}

void comparePictures(const Image& expected, const Image& actual, const CompareRequest& request,
                     ComparedPair& pair) {
  pair.expectedWidth = expected.Width();
  pair.expectedHeight = expected.Height();
  pair.actualWidth = actual.Width();
  pair.actualHeight = actual.Height();
  if (expected.Width() != actual.Width() || expected.Height() != actual.Height()) {
    pair.fail(Result::different,
              "expected " + sizeText(expected) + " pixels, found " + sizeText(actual));
  } else {
    pair.comparison = compare(expected, actual, request.tolerance);
    const bool isOver = pair.comparison->percentOver() > request.failPercent;
    pair.result = isOver ? Result::different : Result::same;
  }
  if (!request.report.empty()) keepPictures(expected, actual, pair);
  if (!request.diff.empty()) pair.difference = differencePicture(expected, actual);
}
