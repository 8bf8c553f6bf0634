// The program `raytracer`. All mistakes that end a run are caught here, and nowhere else: each is
// told in one line on standard error, and its kind decides on the exit status (see ExitStatus).
#include <new>

#include "cli/program.h"
#include "image/output_file.h"
#include "scene/input_error.h"
#include "system/files.h"

namespace {

/// All but what has to be set up first. `argv` may lack even the name of the program.
int runCommandLine(int argc, char** argv) {
  try {
    return runProgram(std::vector<std::string>(argv + (argc > 0), argv + argc));
  } catch (const UsageError& error) {
    complain(error.what());
    return kWrongUsage;
  } catch (const InputError& error) {
    complain(error.what());
    return kSceneAtFault;
  } catch (const std::bad_alloc&) {  // its what() would say nothing to a user
    complain("not enough memory");
    return kOutputFailed;
  } catch (const std::exception& error) {
    complain(error.what());
    return kOutputFailed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  // Before any file is opened: it must not get the number of a standard one that is closed.
  keepStandardFiles();
  // From here on a signal leaves no unfinished file behind.
  removeTemporaryOnSignals();
  return runCommandLine(argc, argv);
}
