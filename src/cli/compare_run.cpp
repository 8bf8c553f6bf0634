// The run of `raytracer -compare`. First comes the list of pairs: of two pictures, of two folders,
// or of a folder and what a table of commands renders; each is compared as soon as both pictures
// are there, so that no more than two are in memory. Then the figures are printed, and the outputs
// written, one that fails costing none of the others.
#include <algorithm>
#include <filesystem>
#include <set>

#include "cli/compare.h"
#include "cli/outputs.h"
#include "cli/program.h"
#include "cli/runs.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "system/files.h"
#include "system/worker_threads.h"

namespace {

namespace fs = std::filesystem;
using Result = ComparedPair::Result;

/// Exit status; the greatest one of all pairs is the program's.
enum CompareStatus { kSame = 0, kDifferent = 1, kUnreadable = 3 };

/// False too where there is nothing, or it cannot be looked at: reading it then says why.
bool isFolder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
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

ReadPicture read(const std::string& file) {
  ReadPicture picture;
  picture.image = readImage(file, &picture.exact);
  return picture;
}

/// Compares the pair's files, where there are two. `rendered` stands for the actual one unless it
/// is null. Where a file cannot be read the pair is unreadable and says why.
void comparePair(const CompareRequest& request, const ReadPicture* rendered, ComparedPair& pair) {
  if (pair.isAtFault()) return;
  const std::string fault = attempt("to compare " + pair.name, [&] {
    const ReadPicture expected = read(pair.expected);
    const ReadPicture actual = rendered ? ReadPicture() : read(pair.actual);
    comparePictures(expected, rendered ? *rendered : actual, request, pair);
  });
  if (!fault.empty()) pair.fail(Result::unreadable, fault);
}

/// Throws UsageError where an output is one of the `pictures`, which are compared, or two outputs
/// are one file, or one goes to standard output beside the figures.
void checkOutputs(const std::vector<std::string>& pictures, const CompareRequest& request,
                  bool quiet) {
  std::vector<std::string> others = pictures;
  for (const std::string& output : {request.diff, request.report, request.csv}) {
    for (const std::string& other : others) {
      if (!isSameOutput(other, output)) continue;
      failUsage("-compare: expected different files, found '", other, "' and '", output, "'");
    }
    others.push_back(output);
    if (quiet || !isSameOutput(output, "-")) continue;
    failUsage("-compare: expected standard output for the figures (which -quiet leaves out), ",
              "found '", output, "' there");
  }
}

/// Renders the pictures of a command and compares each with its partner in `expected`, the pictures
/// of the folder; adds their pairs. Where rendering fails, none of them can be compared.
void compareCommand(const TableCommand& command, const CompareRequest& request,
                    const std::vector<std::string>& expected, std::vector<ComparedPair>& pairs) {
  std::vector<Output> outputs = outputsOf(command.render);
  const std::string fault = attempt("to compare " + outputs[0].file,
                                    [&] { outputs = renderPictures(command.render, command.run); });
  for (Output& output : outputs) {
    const std::string partner = partnerOf(output.file, expected);
    pairs.push_back({output.file, inFolder(request.expected, partner), command.text});
    if (partner.empty()) pairs.back().fail(Result::unexpected, "no expected picture");
    if (!fault.empty()) pairs.back().fail(Result::unreadable, fault);
    const ReadPicture rendered = {std::move(output.image), std::move(output.exact)};
    comparePair(request, &rendered, pairs.back());
  }
}

/// Pairs come in the order of the table; then the pictures of the folder that nobody has rendered.
/// Unless -progress is given there is no line of progress for each command.
std::vector<ComparedPair> compareTable(const CompareRequest& request, const RunRequest& run) {
  const std::vector<std::string> expected = picturesIn(request.expected);
  // A long comparison is not to end with the refusal to write its result.
  for (const std::string& name : expected) {
    checkOutputs({inFolder(request.expected, name)}, request, run.quiet);
  }
  RunRequest defaults = run;
  defaults.progress = run.progress.value_or(false);
  std::vector<ComparedPair> pairs;
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
std::vector<ComparedPair> compareAll(const CompareRequest& request, const RunRequest& run) {
  if (isFolder(request.expected)) {
    if (!request.diff.empty()) throw UsageError("-diff: expected two pictures, found a folder");
    if (!isFolder(request.actual)) return compareTable(request, run);
  }
  if (!isFolder(request.expected) && isFolder(request.actual)) {
    throw ImageError(request.actual,
                     "expected a picture to compare with " + request.expected + ", found a folder");
  }
  std::vector<ComparedPair> pairs = pairsIn(request.expected, request.actual);
  // All before the first one is read, likewise.
  for (const ComparedPair& pair : pairs) {
    checkOutputs({pair.expected, pair.actual}, request, run.quiet);
  }
  for (ComparedPair& pair : pairs) comparePair(request, nullptr, pair);
  return pairs;
}

/// The worst of all pairs.
int statusOf(const std::vector<ComparedPair>& pairs) {
  int status = kSame;
  for (const ComparedPair& pair : pairs) {
    const int found = pair.result == Result::unreadable ? kUnreadable : kDifferent;
    if (pair.result != Result::same) status = std::max(status, found);
  }
  return status;
}

/// False where one of the files cannot be written, which has then been said; the others are written
/// all the same. The report has the worst pair first, and so comes last: it changes their order.
bool writeOutputs(std::vector<ComparedPair>& pairs, const CompareRequest& request) {
  bool written = true;
  const auto attemptWriting = [&written](const auto& write) {
    written = attempt("for -diff, -csv or -report", write).empty() && written;
  };
  if (const Image& difference = pairs[0].difference; difference.Width() > 0) {
    attemptWriting([&] { writePicture(difference, request.diff, hardwareThreads()); });
  }
  if (!request.csv.empty()) attemptWriting([&] { addToCsv(pairs, request.csv); });
  if (!request.report.empty()) {
    attemptWriting([&] {
      std::stable_sort(pairs.begin(), pairs.end(), isWorse);
      const std::string page = reportPage(pairs, request);
      writeFile(request.report, page.data(), page.size());
    });
  }
  return written;
}

}  // namespace

int runComparison(const CompareRequest& request, const RunRequest& run) {
  checkOutputs({request.expected, request.actual}, request, run.quiet);
  std::vector<ComparedPair> pairs;
  try {
    pairs = compareAll(request, run);
  } catch (const ImageError& error) {
    complain(error.what());
    return kUnreadable;
  }
  for (ComparedPair& pair : pairs) pair.given = request.actual;
  if (pairs.empty()) {
    complain(request.expected + ": expected pictures to compare, found none");
    return kUnreadable;
  }
  const int status = statusOf(pairs);
  // Figures are printed before any file is written, so that one that fails does not cost them.
  const bool isSingle = !isFolder(request.expected);
  const std::string text = isSingle ? figureLines(pairs[0], request) : pairLines(pairs);
  const bool printed = run.quiet || print(text) == kDone;
  const bool written = writeOutputs(pairs, request);
  return (printed && written) || status != kSame ? status : kDifferent;
}
