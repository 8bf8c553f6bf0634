// The run of `raytracer -compare`. First comes the list of pairs: of two pictures, of two folders,
// or of a folder and what a table of commands renders; each is compared as soon as both pictures
// are there, so that no more than two are in memory. Then the figures are printed, and the outputs
// written, one that fails costing none of the others.
//
// Pictures of two folders are paired by their paths below them. Endings may differ, so that a TGA
// can be compared with the PNG it was converted to; a path that is the same with its ending goes
// first.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "cli/compare.h"
#include "cli/outputs.h"
#include "cli/program.h"
#include "cli/runs.h"
#include "image/bytes.h"
#include "image/output_file.h"
#include "system/worker_threads.h"

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;
using Pairs = std::vector<ComparedPair>;
using Result = ComparedPair::Result;

/// Exit status; the worst of all pairs decides.
enum CompareStatus { kSame = 0, kDifferent = 1, kUnreadable = 3 };

/// False too where there is nothing, or it cannot be looked at: reading it then says why.
bool isFolder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// By the ending alone, in capitals or not: a file that is no picture in spite of it, or one that
/// is not read, is unreadable, and so told.
bool isPictureName(const fs::path& path) {
  static constexpr std::string_view kEndings[] = {".tga", ".png", ".bmp",  ".ppm",
                                                  ".pgm", ".pfm", ".jpg",  ".jpeg",
                                                  ".gif", ".tif", ".tiff", ".webp"};
  std::string ending = path.extension().string();
  for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
  return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

/// All pictures below `folder`, however deep, as paths relative to it. The order of a folder is the
/// file system's own; sorted, it is the same everywhere. Links to folders are not followed. Throws
/// ImageError where a folder cannot be read.
Names picturesIn(const std::string& folder) {
  Names names;
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

/// The path of `name` in `folder`; "" for "".
std::string inFolder(const std::string& folder, const std::string& name) {
  return name.empty() ? "" : (fs::path(folder) / name).string();
}

/// The picture of that name in `pictures`, which are sorted, else the first one whose path is the
/// same but for the ending (out.tga and out.png); "" where there is none.
std::string partnerOf(const std::string& name, const Names& pictures) {
  if (std::binary_search(pictures.begin(), pictures.end(), name)) return name;
  const auto withoutEnding = [](const fs::path& path) {
    return fs::path(path).replace_extension();
  };
  const auto found = std::find_if(pictures.begin(), pictures.end(), [&](const std::string& other) {
    return withoutEnding(other) == withoutEnding(name);
  });
  return found == pictures.end() ? "" : *found;
}

/// Of two folders, not compared yet: each expected picture with its partner among the actual ones,
/// or missing, and the actual ones that are nobody's partner, which are unexpected; sorted by name.
/// Two expected pictures may have the same partner, for example a TGA and a PNG of one name.
Pairs pairsIn(const std::string& expected, const std::string& actual) {
  const Names actualNames = picturesIn(actual);
  Pairs pairs;
  std::set<std::string> taken;
  for (const std::string& name : picturesIn(expected)) {
    const std::string partner = *taken.insert(partnerOf(name, actualNames)).first;
    const bool isAlone = partner.empty();
    pairs.push_back({name, inFolder(expected, name), inFolder(actual, partner),
                     isAlone ? Result::missing : Result::same, isAlone ? "no actual picture" : ""});
  }
  for (const std::string& name : actualNames) {
    if (taken.count(name) > 0) continue;
    pairs.push_back({name, "", inFolder(actual, name), Result::unexpected, "no expected picture"});
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const ComparedPair& a, const ComparedPair& b) { return a.name < b.name; });
  return pairs;
}

/// Calls work(), which takes memory `purpose`, "to ...". Returns "", or complains and returns why
/// it failed.
template <class Work>
std::string attempt(const std::string& purpose, const Work& work) {
  try {
    withMemory(purpose, work);
    return "";
  } catch (const UsageError&) {
    throw;
  } catch (const std::exception& error) {
    complain(error.what());
    return error.what();
  }
}

/// A pipe that is named may be meant; one that lies in a folder would be waited for in vain.
ReadPicture read(const std::string& file, bool isNamed) {
  std::error_code ignored;
  if (!isNamed && fs::is_fifo(file, ignored)) {
    throw ImageError(file, "expected a file, found a pipe");
  }
  ReadPicture picture;
  picture.image = readImage(file, &picture.exact);
  return picture;
}

/// Compares the pair's pictures, which are not kept, and enters what came of it. For the report
/// they are kept as they stand there, compressed: it holds those of all pairs at once.
void comparePictures(const ReadPicture& expected, const ReadPicture& actual,
                     const CompareRequest& request, ComparedPair& pair) {
  pair.expectedSize = {expected.image.Width(), expected.image.Height()};
  pair.actualSize = {actual.image.Width(), actual.image.Height()};
  const std::string wanted = pair.expectedSize.text(), found = pair.actualSize.text();
  bool isSame = wanted == found;
  if (isSame) {
    pair.comparison = compare(expected, actual, request.tolerance);
    isSame = pair.comparison->percentOver() <= request.failPercent;
  } else {
    pair.fault = "expected " + wanted + " pixels, found " + found;
  }
  pair.result = isSame ? Result::same : Result::different;
  if (!request.report.empty()) pair.figures = reportFigures(expected, actual, pair);
  if (!request.diff.empty()) pair.difference = differencePicture(expected, actual);
}

/// Compares the pair's files, where there are two. `rendered` stands for the actual one unless it
/// is null. Where a file cannot be read the pair is unreadable and says why.
void comparePair(const CompareRequest& request, const ReadPicture* rendered, ComparedPair& pair) {
  if (pair.isAtFault()) return;
  const bool isNamed = !isFolder(request.expected);
  const std::string fault = attempt("to compare " + pair.name, [&] {
    const ReadPicture expected = read(pair.expected, isNamed);
    if (rendered) return comparePictures(expected, *rendered, request, pair);
    comparePictures(expected, read(pair.actual, isNamed), request, pair);
  });
  if (fault.empty()) return;
  pair.result = Result::unreadable;
  pair.fault = fault;
}

/// Throws UsageError where an output is one of the `pictures`, which are compared, or two outputs
/// are one file, or one goes to standard output beside the figures.
void checkOutputs(Names pictures, const CompareRequest& request, bool quiet) {
  for (const std::string& output : {request.diff, request.report, request.csv}) {
    for (const std::string& other : pictures) checkDifferent("-compare", other, output);
    pictures.push_back(output);
    refuseIf(
        !quiet && isSameOutput(output, "-"),
        "-compare: expected standard output for the figures (which -quiet leaves out), found '",
        output, "' there");
  }
}

/// Renders the pictures of a command and compares each with its partner in `expected`, the pictures
/// of the folder; adds their pairs. Where rendering fails, none of them can be compared.
void compareCommand(const TableCommand& command, const CompareRequest& request,
                    const Names& expected, Pairs& pairs) {
  std::vector<Output> outputs = outputsOf(command.render);
  const std::string fault = attempt("to compare " + outputs[0].file,
                                    [&] { outputs = renderPictures(command.render, command.run); });
  for (Output& output : outputs) {
    const std::string partner = partnerOf(output.file, expected);
    const bool isAlone = partner.empty() && fault.empty();
    pairs.push_back({output.file, inFolder(request.expected, partner), command.text,
                     isAlone         ? Result::unexpected
                     : fault.empty() ? Result::same
                                     : Result::unreadable,
                     isAlone ? "no expected picture" : fault});
    const ReadPicture rendered = {std::move(output.image), std::move(output.exact)};
    comparePair(request, &rendered, pairs.back());
  }
}

/// Pairs come in the order of the table; then the pictures of the folder that nobody has rendered.
/// Unless -progress is given there is no line of progress for each command.
Pairs compareTable(const CompareRequest& request, const RunRequest& run) {
  const Names expected = picturesIn(request.expected);
  // A long comparison is not to end with the refusal to write its result.
  for (const std::string& name : expected) {
    checkOutputs({inFolder(request.expected, name)}, request, run.quiet);
  }
  RunRequest defaults = run;
  defaults.progress = run.progress.value_or(false);
  Pairs pairs;
  for (const TableCommand& command : readCommandTable(request.actual, defaults)) {
    compareCommand(command, request, expected, pairs);
  }
  std::set<std::string> taken;
  for (const ComparedPair& pair : pairs) taken.insert(pair.expected);
  for (const std::string& name : expected) {
    const std::string file = inFolder(request.expected, name);
    if (taken.count(file) > 0) continue;
    pairs.push_back({name, file, "", Result::missing, "no command gives this picture"});
  }
  return pairs;
}

/// What EXPECTED and ACTUAL are decides: see runComparison.
Pairs compareAll(const CompareRequest& request, const RunRequest& run) {
  const std::string &expected = request.expected, &actual = request.actual;
  Pairs pairs;
  if (isFolder(expected)) {
    refuseIf(!request.diff.empty(), "-diff: expected two pictures, found a folder");
    if (!isFolder(actual)) return compareTable(request, run);
    pairs = pairsIn(expected, actual);
  } else if (isFolder(actual)) {
    throw ImageError(actual, "expected a picture to compare with " + expected + ", found a folder");
  } else {
    pairs = {{fs::path(expected).filename().string(), expected, actual}};
  }
  // All before the first one is read, likewise.
  for (const ComparedPair& pair : pairs) {
    checkOutputs({pair.expected, pair.actual}, request, run.quiet);
  }
  for (ComparedPair& pair : pairs) comparePair(request, nullptr, pair);
  return pairs;
}

/// Results stand in the order of their badness.
int statusOf(const Pairs& pairs) {
  Result worst = Result::same;
  for (const ComparedPair& pair : pairs) worst = std::max(worst, pair.result);
  return worst == Result::same ? kSame : worst == Result::unreadable ? kUnreadable : kDifferent;
}

/// False where one of the files cannot be written, which has then been said; the others are written
/// all the same.
bool writeOutputs(Pairs pairs, const CompareRequest& request) {
  bool written = true;
  const auto attemptWriting = [&written](const auto& write) {
    written = attempt("for -diff, -csv or -report", write).empty() && written;
  };
  if (const Image& difference = pairs[0].difference; difference.Width() > 0) {
    attemptWriting([&] { writePicture(difference, request.diff, hardwareThreads()); });
  }
  if (!request.csv.empty()) attemptWriting([&] { addToCsv(pairs, request); });
  if (!request.report.empty()) {
    attemptWriting([&] {
      const std::string page = reportPage(std::move(pairs), request);
      writeFile(request.report, page.data(), page.size());
    });
  }
  return written;
}

}  // namespace

int runComparison(const CompareRequest& request, const RunRequest& run) {
  checkOutputs({request.expected, request.actual}, request, run.quiet);
  Pairs pairs;
  try {
    pairs = compareAll(request, run);
    if (pairs.empty()) {
      throw ImageError(request.expected, "expected pictures to compare, found none");
    }
  } catch (const ImageError& error) {
    complain(error.what());
    return kUnreadable;
  }
  const int status = statusOf(pairs);
  // Figures are printed before any file is written, so that one that fails does not cost them.
  const bool isSingle = !isFolder(request.expected);
  const std::string text = isSingle ? figureLines(pairs[0], request) : pairLines(pairs);
  const bool printed = run.quiet || print(text) == kDone;
  const bool written = writeOutputs(std::move(pairs), request);
  return (printed && written) || status != kSame ? status : kDifferent;
}
