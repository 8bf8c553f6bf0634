// The run of `raytracer -compare`.
#include "cli/compare_run.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <set>

#include "cli/command_table.h"
#include "cli/compare_output.h"
#include "cli/outputs.h"
#include "cli/picture_pairs.h"
#include "cli/program.h"
#include "cli/render_run.h"
#include "image/output_file.h"
#include "image/picture_file.h"
#include "scene/source_text.h"
#include "system/files.h"
#include "system/worker_threads.h"

namespace {

namespace fs = std::filesystem;
using Result = ComparedPair::Result;

bool isFolder(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

/// Calls work(); where a picture or scene is at fault, the pair is unreadable and says why.
template <class Work>
void attempt(ComparedPair& pair, const Work& work) {
  try {
    work();
    return;
  } catch (const std::bad_alloc&) {
    pair.fault = "not enough memory to compare " + pair.name;
  } catch (const UsageError&) {
    throw;
  } catch (const std::exception& error) {
    pair.fault = error.what();
  }
  pair.result = Result::unreadable;
  complain(pair.fault);
}

/// Where -diff is given, `difference` is then the picture of the differences of two that could be
/// read.
ComparedPair compareFiles(const PicturePair& files, const CompareRequest& options,
                          Image& difference) {
  ComparedPair pair;
  pair.name = files.name;
  pair.expected = files.expected;
  pair.actual = files.actual;
  if (files.expected.empty() || files.actual.empty()) {
    pair.result = files.actual.empty() ? Result::missing : Result::unexpected;
    pair.fault = files.actual.empty() ? "no actual picture" : "no expected picture";
    return pair;
  }
  attempt(pair, [&] {
    const Image expected = readImage(files.expected), actual = readImage(files.actual);
    comparePictures(expected, actual, options, pair);
    if (!options.diff.empty()) difference = differencePicture(expected, actual);
  });
  return pair;
}

[[noreturn]] void refuse(const std::string& a, const std::string& b) {
  throw UsageError("-compare: expected different files, found '" + a + "' and '" + b + "'");
}

/// Throws UsageError where an output would replace the picture.
void checkNoOutput(const std::string& picture, const CompareRequest& options) {
  for (const std::string* output : {&options.report, &options.csv}) {
    if (isSameOutput(picture, *output)) refuse(picture, *output);
  }
}

std::vector<ComparedPair> compareFolders(const CompareRequest& options) {
  const std::vector<PicturePair> found = pairsIn(options.expected, options.actual);
  for (const PicturePair& files : found) {
    checkNoOutput(files.expected, options);
    checkNoOutput(files.actual, options);
  }
  std::vector<ComparedPair> pairs;
  pairs.reserve(found.size());
  Image none;
  for (const PicturePair& files : found) pairs.push_back(compareFiles(files, options, none));
  return pairs;
}

/// Renders the pictures of table lines and compares them with those of a folder.
class TableRun {
 public:
  TableRun(const CompareRequest& compare, const RunRequest& run)
      : compare_(compare), run_(run), expected_(picturesIn(compare.expected)) {
    run_.memoryLimit = 0;  // that of this run, whose threads are as many as it allows
    if (run_.progress == RunRequest::Progress::automatic) {
      run_.progress = RunRequest::Progress::off;
    }
    for (const std::string& name : expected_) {
      checkNoOutput(pairFor(name, name).expected, compare_);
    }
  }

  std::vector<ComparedPair> run() {
    for (const TableCommand& command : readCommandTable(compare_.actual, run_)) {
      compareOutputs(command);
    }
    for (const std::string& name : expected_) {
      if (taken_.count(name) > 0) continue;
      pairs_.push_back(pairFor(name, name));
      pairs_.back().result = Result::missing;
      pairs_.back().fault = "no command gives this picture";
    }
    return std::move(pairs_);
  }

 private:
  ComparedPair pairFor(const std::string& name, const std::string& expected) const {
    ComparedPair pair;
    pair.name = name;
    if (!expected.empty()) pair.expected = (fs::path(compare_.expected) / expected).string();
    return pair;
  }

  void compareOutputs(const TableCommand& command) {
    std::vector<Output> outputs = outputsOf(command.render.results);
    ComparedPair whole = pairFor(outputs[0].file, "");
    attempt(whole, [&] { outputs = renderPictures(command.render, command.run); });
    for (const Output& output : outputs) {
      const std::string partner = partnerOf(output.file, expected_);
      if (!partner.empty()) taken_.insert(partner);
      ComparedPair pair = pairFor(output.file, partner);
      pair.actual = command.text;
      if (whole.result == Result::unreadable) {
        pair.result = whole.result;
        pair.fault = whole.fault;
      } else if (partner.empty()) {
        pair.result = Result::unexpected;
        pair.fault = "no expected picture";
      } else {
        attempt(pair,
                [&] { comparePictures(readImage(pair.expected), output.image, compare_, pair); });
      }
      pairs_.push_back(std::move(pair));
    }
  }

  const CompareRequest& compare_;
  RunRequest run_;  // what the lines of the table begin with
  const std::vector<std::string> expected_;
  std::set<std::string> taken_;
  std::vector<ComparedPair> pairs_;
};

bool beginsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// Adds the rows to what is in the file, which begins with the heading unless it is new or empty.
void addToCsv(const std::vector<ComparedPair>& pairs, const std::string& path) {
  // Two runs at once would each lose the other's rows. Of a file that is read, added to and
  // replaced, the lock can only be its folder: a lock on the file itself would go with the old one.
  std::error_code ignored;
  const fs::path place = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  const OpenFile folder(place.parent_path().string());
  folder.lock(true);
  std::string text, reason;
  if (fs::is_regular_file(path, ignored) && !readWholeFile(path, text, reason)) {
    throw OutputError(path, "what it holds cannot be read: " + reason);
  }
  if (text.empty()) text = csvHeading();
  if (!beginsWith(text, csvHeading())) {
    throw OutputError(path, "it does not begin with the heading of such a table");
  }
  if (text.back() != '\n') text += "\r\n";
  for (const ComparedPair& pair : pairs) text += csvRow(pair);
  writeFile(path, text.data(), text.size());
}

CompareStatus statusOf(const std::vector<ComparedPair>& pairs) {
  CompareStatus status = kSame;
  for (const ComparedPair& pair : pairs) {
    if (pair.result == Result::unreadable) return kUnreadable;
    if (pair.result != Result::same) status = kDifferent;
  }
  return status;
}

/// False where one of the files cannot be written, which has then been said.
bool writeOutputs(std::vector<ComparedPair>& pairs, const Image& difference,
                  const CompareRequest& options) {
  bool written = true;
  const auto attemptWriting = [&written](const auto& write) {
    try {
      write();
      return;
    } catch (const std::bad_alloc&) {
      complain("not enough memory for -diff, -csv or -report");
    } catch (const std::exception& error) {
      complain(error.what());
    }
    written = false;
  };
  if (difference.Width() > 0) {
    attemptWriting([&] { writePicture(difference, options.diff, hardwareThreads()); });
  }
  if (!options.csv.empty()) attemptWriting([&] { addToCsv(pairs, options.csv); });
  if (!options.report.empty()) {
    attemptWriting([&] {
      std::stable_sort(pairs.begin(), pairs.end(), isWorse);
      const std::string page = reportPage(pairs, options);
      writeFile(options.report, page.data(), page.size());
    });
  }
  return written;
}

/// Throws UsageError where an output is one of the things compared, or two outputs are one file, or
/// one goes to standard output beside the figures.
void checkOutputs(const CompareRequest& options, bool quiet) {
  const std::string* const files[] = {&options.expected, &options.actual, &options.diff,
                                      &options.report, &options.csv};
  for (int i = 2; i < 5; ++i) {
    for (int k = 0; k < i; ++k) {
      if (isSameOutput(*files[k], *files[i])) refuse(*files[k], *files[i]);
    }
    if (quiet || !isSameOutput(*files[i], "-")) continue;
    throw UsageError(
        "-compare: expected standard output for the figures (which -quiet leaves "
        "out), found '" +
        *files[i] + "' there");
  }
}

std::vector<ComparedPair> compareAll(const CompareRequest& compare, const RunRequest& run,
                                     Image& difference) {
  const bool folder = isFolder(compare.expected), both = folder && isFolder(compare.actual);
  if (!folder) {
    const std::string name = fs::path(compare.expected).filename().string();
    return {compareFiles({name, compare.expected, compare.actual}, compare, difference)};
  }
  if (!compare.diff.empty()) throw UsageError("-diff: expected two pictures, found a folder");
  return both ? compareFolders(compare) : TableRun(compare, run).run();
}

}  // namespace

int runComparison(const CompareRequest& compare, const RunRequest& run) {
  checkOutputs(compare, run.quiet);
  std::vector<ComparedPair> pairs;
  Image difference;
  try {
    pairs = compareAll(compare, run, difference);
  } catch (const ImageError& error) {
    complain(error.what());
    return kUnreadable;
  }
  if (pairs.empty()) {
    complain(compare.expected + ": expected pictures to compare, found none");
    return kUnreadable;
  }
  const CompareStatus status = statusOf(pairs);
  const bool single = !isFolder(compare.expected);
  const std::string text = single ? figureLines(pairs[0], compare) : pairLines(pairs);
  const bool printed = run.quiet || print(text) == kDone;
  const bool written = writeOutputs(pairs, difference, compare);
  return (printed && written) || status != kSame ? status : kDifferent;
}
