// ComparedPair: which pictures belong together, and comparing them.
//
// Pictures of two folders are paired by their paths below them. Endings may differ, so that a TGA
// can be compared with the PNG it was converted to; a path that is the same with its ending goes
// first.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <tuple>

#include "cli/compare.h"
#include "image/bytes.h"

namespace {

namespace fs = std::filesystem;
using Result = ComparedPair::Result;

/// By the ending alone: a file that is no picture in spite of it is unreadable, and so told.
bool isPictureName(const fs::path& path) {
  static constexpr std::string_view kEndings[] = {".tga", ".png", ".bmp",  ".ppm",
                                                  ".pgm", ".pfm", ".jpg",  ".jpeg",
                                                  ".gif", ".tif", ".tiff", ".webp"};
  std::string ending = path.extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

/// out/a.tga is out/a.
fs::path withoutEnding(const std::string& name) { return fs::path(name).replace_extension(); }

/// What is alone or unreadable before other sizes, and these before other pixels. Greater is worse.
auto badnessOf(const ComparedPair& pair) {
  const int kind = pair.isAtFault() ? 2 : int(pair.result);
  const bool otherSize = !pair.comparison && !pair.isAtFault();
  const Comparison figures = pair.comparison.value_or(Comparison());
  return std::make_tuple(kind, otherSize, figures.percentOver(), figures.rms);
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
  std::error_code error, ignored;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    if (!isPictureName(entry->path()) || entry->is_directory(ignored)) continue;
    names.push_back(entry->path().lexically_relative(folder).string());
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

/// Looks for a partner for each expected picture; the result is sorted, as they come in two rows.
/// Two expected pictures may have the same partner, for example a TGA and a PNG of one name.
std::vector<ComparedPair> pairsIn(const std::string& expected, const std::string& actual) {
  std::error_code ignored;
  if (!fs::is_directory(expected, ignored)) {
    return {{fs::path(expected).filename().string(), expected, actual}};
  }
  const std::vector<std::string> actualNames = picturesIn(actual);
  std::vector<ComparedPair> pairs;
  std::set<std::string> taken;
  for (const std::string& name : picturesIn(expected)) {
    const std::string partner = *taken.insert(partnerOf(name, actualNames)).first;
    pairs.push_back({name, inFolder(expected, name), inFolder(actual, partner)});
    if (partner.empty()) pairs.back().fail(Result::missing, "no actual picture");
  }
  // Whoever has been nobody's partner is alone.
  for (const std::string& name : actualNames) {
    if (taken.count(name) > 0) continue;
    pairs.push_back({name, "", inFolder(actual, name), Result::unexpected, "no expected picture"});
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const ComparedPair& a, const ComparedPair& b) { return a.name < b.name; });
  return pairs;
}

bool isWorse(const ComparedPair& a, const ComparedPair& b) {
  const auto p = badnessOf(a), q = badnessOf(b);
  return p != q ? p > q : a.name < b.name;
}

/// For the report the pictures are kept as they stand there, compressed: it holds those of all
/// pairs at once, and their pixels would take more memory.
void comparePictures(const ReadPicture& expected, const ReadPicture& actual,
                     const CompareRequest& request, ComparedPair& pair) {
  pair.expectedSize = {expected.image.Width(), expected.image.Height()};
  pair.actualSize = {actual.image.Width(), actual.image.Height()};
  if (pair.expectedSize.text() != pair.actualSize.text()) {
    pair.fail(Result::different,
              "expected " + pair.expectedSize.text() + " pixels, found " + pair.actualSize.text());
  } else {
    pair.comparison = compare(expected, actual, request.tolerance);
    const bool isOver = pair.comparison->percentOver() > request.failPercent;
    pair.result = isOver ? Result::different : Result::same;
  }
  if (!request.report.empty()) pair.figures = reportFigures(expected, actual, pair);
  if (!request.diff.empty()) pair.difference = differencePicture(expected, actual);
}
