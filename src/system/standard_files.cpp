// Standard input, output and error of the process.
#include "system/standard_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

void keepStandardFiles() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(descriptor, F_GETFD) >= 0) continue;
    // The lowest free number is this one. Opened the wrong way round: any use is an error.
    const int wrongWay = descriptor == STDOUT_FILENO ? O_RDONLY : O_WRONLY;
    // Where there is no /dev, a folder does: to read and to write it are errors too.
    if (open("/dev/null", wrongWay) < 0 && open("/", O_RDONLY | O_DIRECTORY) < 0) return;
  }
}
