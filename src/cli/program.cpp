// The run of the program.
#include "cli/program.h"

#include <new>
#include <stdexcept>
#include <system_error>

#include "cli/compare_run.h"
#include "cli/merge_run.h"
#include "cli/option_table.h"
#include "cli/out_of_memory.h"
#include "cli/render_run.h"
#include "cli/scene_input.h"
#include "system/memory.h"
#include "system/worker_threads.h"

namespace {

/// Enough to read the deepest scene (measured: below 1 MB, 4 MB with sanitizers), whatever limit
/// the user's shell sets for the first thread.
constexpr std::size_t kRunStack = 8 << 20;

int runHere(const Options& options) {
  if (options.shortHelp) return print(shortHelp());
  if (options.help) return print(fullHelp());
  if (options.version) return print(versionText() + "\n");
  if (options.man) return print(manPage());
  if (options.completion) return print(completionScript());
  if (options.check) return checkScene(options);
  if (options.compare.isWanted()) return runComparison(options);
  checkFiles(options);
  if (options.merge.isWanted()) {
    return withMemory("to merge", [&] { return runMerge(options.merge); });
  }
  return renderScene(options);
}

int runOnOwnStack(const Options& options) {
  int status = kDone;
  runOnThreads(1, kRunStack, [&](int) { status = runHere(options); });
  return status;
}

/// Names the limit where it is what ended the run.
int runWithin(int megabytes, const Options& options) {
  const std::string limit = "-memory_limit " + std::to_string(megabytes) + ": ";
  limitMemory(std::size_t(megabytes) << 20);
  try {
    return runOnOwnStack(options);
  } catch (const std::bad_alloc&) {
    throw std::runtime_error(limit + "not enough memory");
  } catch (const OutOfMemory& error) {
    throw std::runtime_error(limit + error.what());
  } catch (const std::system_error& error) {  // no room for a thread's stack
    throw std::runtime_error(limit + error.what());
  }
}

}  // namespace

int runProgram(const Options& options) {
  return options.memoryLimit > 0 ? runWithin(options.memoryLimit, options) : runOnOwnStack(options);
}
