// The program `raytracer`. All mistakes that end a run are caught here, and nowhere else.
#include <new>

#include "cli/program.h"
#include "image/output_file.h"
#include "scene/input_error.h"
#include "system/files.h"

namespace {

int runCommandLine(int argc, char** argv) {
  try {
    return runProgram(std::vector<std::string>(argv + (argc > 0), argv + argc));
  } catch (const UsageError& error) {
    complain(error.what());
    return kWrongUsage;
  } catch (const InputError& error) {
    complain(error.what());
    return kSceneAtFault;
  } catch (const std::bad_alloc&) {
    complain("not enough memory");
    return kOutputFailed;
  } catch (const std::exception& error) {
    complain(error.what());
    return kOutputFailed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  keepStandardFiles();
  removeTemporaryOnSignals();
  return runCommandLine(argc, argv);
}
