// The run of the program. A command line is read into a request, and one of five runs answers it: a
// text about the program, -check, -compare, -merge, or a picture. All of it happens on a thread
// with a stack of a stated size, and within the memory that -memory_limit grants.
//
// Messages go out without a copy: there may be no memory for one.
#include "cli/program.h"

#include <sys/uio.h>
#include <unistd.h>

#include <cstdio>
#include <iterator>
#include <system_error>

#include "cli/arguments.h"
#include "cli/runs.h"
#include "image/output_file.h"
#include "system/files.h"
#include "system/memory.h"
#include "system/worker_threads.h"

namespace {

/// Enough to read the deepest scene (measured: below 1 MB, 4 MB with sanitizers), whatever limit
/// the user's shell sets for the first thread.
constexpr std::size_t kRunStack = 8 << 20;

/// One of the texts about the program, whole.
std::string textOf(const Request& request) {
  if (request.text == ProgramText::shortHelp) return shortHelp();
  if (request.text == ProgramText::version) return versionText() + "\n";
  if (request.text == ProgramText::man) return manPage();
  if (request.text == ProgramText::completion) return completionScript();
  return request.topic ? request.topic->text : fullHelp();
}

int answer(const Request& request) {
  if (request.text != ProgramText::none) return print(textOf(request));
  if (request.check) return checkScene(request.render.picture, request.run.quiet);
  if (request.compare.isWanted()) return runComparison(request.compare, request.run);
  if (!request.merge.isWanted()) return renderScene(request.render, request.run);
  return withMemory("to merge", [&] { return runMerge(request.merge); });
}

int answerOnOwnStack(const Request& request) {
  int status = kDone;
  runOnThreads(1, kRunStack, [&](int) { status = answer(request); });
  return status;
}

/// Names the limit where it is what ended the run.
int answerWithin(int megabytes, const Request& request) {
  const std::string limit = "-memory_limit " + std::to_string(megabytes) + ": ";
  limitMemory(std::size_t(megabytes) << 20);
  try {
    return answerOnOwnStack(request);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(limit + "not enough memory");
  } catch (const OutOfMemory& error) {
    throw std::runtime_error(limit + error.what());
  } catch (const std::system_error& error) {  // no room for a thread's stack
    throw std::runtime_error(limit + error.what());
  }
}

}  // namespace

int runProgram(const std::vector<std::string>& words) {
  const Request request = parseRequest(words);
  const int limit = request.run.memoryLimit;
  return limit > 0 ? answerWithin(limit, request) : answerOnOwnStack(request);
}

void complain(std::string_view message) {
  const auto piece = [](std::string_view text) {
    return iovec{const_cast<char*>(text.data()), text.size()};
  };
  iovec pieces[] = {piece(isLineOpen() ? "\nraytracer: " : "raytracer: "), piece(message),
                    piece("\n")};
  setLineOpen(false);
  // As a rule once round: a terminal, file or pipe takes a message as a whole.
  for (iovec* next = pieces;;) {
    const auto count = int(std::end(pieces) - next);
    const ssize_t written = uninterrupted([&] { return writev(STDERR_FILENO, next, count); });
    if (written <= 0) return;  // nobody to tell
    auto done = std::size_t(written);
    for (; next != std::end(pieces) && done >= next->iov_len; ++next) done -= next->iov_len;
    if (next == std::end(pieces)) return;
    *next = piece({static_cast<char*>(next->iov_base) + done, next->iov_len - done});
  }
}

int print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0 && !std::ferror(stdout)) return kDone;
  complain("cannot write to standard output");
  return kOutputFailed;
}
