// The run of the program.
#include "cli/program.h"

#include <new>
#include <stdexcept>
#include <system_error>

#include "cli/arguments.h"
#include "cli/compare_run.h"
#include "cli/file_names.h"
#include "cli/merge_run.h"
#include "cli/out_of_memory.h"
#include "cli/render_run.h"
#include "cli/scene_input.h"
#include "system/memory.h"
#include "system/worker_threads.h"

namespace {

/// Enough to read the deepest scene (measured: below 1 MB, 4 MB with sanitizers), whatever limit
/// the user's shell sets for the first thread.
constexpr std::size_t kRunStack = 8 << 20;

int printText(ProgramText text) {
  switch (text) {
    case ProgramText::shortHelp:
      return print(shortHelp());
    case ProgramText::help:
      return print(fullHelp());
    case ProgramText::version:
      return print(versionText() + "\n");
    case ProgramText::man:
      return print(manPage());
    default:
      return print(completionScript());
  }
}

int runHere(const Request& request) {
  if (request.text != ProgramText::none) return printText(request.text);
  if (request.check) return checkScene(request.render.picture.scene, request.run.quiet);
  if (request.compare.isWanted()) return runComparison(request.compare, request.run);
  if (request.merge.isWanted()) {
    checkMergedFiles(request.merge);
    return withMemory("to merge", [&] { return runMerge(request.merge); });
  }
  checkFiles(request.render, request.run.checkpoint);
  return renderScene(request.render, request.run);
}

int runOnOwnStack(const Request& request) {
  int status = kDone;
  runOnThreads(1, kRunStack, [&](int) { status = runHere(request); });
  return status;
}

/// Names the limit where it is what ended the run.
int runWithin(int megabytes, const Request& request) {
  const std::string limit = "-memory_limit " + std::to_string(megabytes) + ": ";
  limitMemory(std::size_t(megabytes) << 20);
  try {
    return runOnOwnStack(request);
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
  return limit > 0 ? runWithin(limit, request) : runOnOwnStack(request);
}
