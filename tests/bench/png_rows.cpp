// Writing a large PNG file on one thread.
#include "process.h"
#include "rows.h"
#include "scene_runs.h"

namespace bench {

void runPngRows(const BenchOptions& options) {
  constexpr double kMegabytes = 4000 * 4000 * 3 / 1e6;
  printHeading("PNG, the still life at 4000 x 4000 with one bounce, one thread");
  const ScratchFolder folder;
  const std::vector<std::string> arguments =
      ownCommand("20_still_life", folder.file("out.png"),
                 {"-size", "4000", "4000", "-bounces", "1", "-threads", "1"});
  const std::vector<Samples> seconds =
      statsInTurns(options, options.rounds, arguments, "seconds writing: ");
  printRow("writing PNG", "s", seconds[0], "-against", seconds[1]);
  printAlone("writing PNG (at least 40)", "MB/s", seconds[0].inverted(kMegabytes));
}

}  // namespace bench
