// Runs of the program on the project's own scenes, measured by what -stats says.
#pragma once
#include <string>
#include <vector>

#include "measure.h"
#include "options.h"

namespace bench {

/// The arguments of the command in the comment of scenes/`name`.txt, with `output` as its output
/// and `more` behind them. Throws std::runtime_error where the scene has none.
std::vector<std::string> ownCommand(const std::string& name, const std::string& output,
                                    const std::vector<std::string>& more);

/// The number behind `label` in the -stats of the program with these arguments, `rounds` times:
/// ours, and in turns with it options.against's; without one the second Samples are empty.
std::vector<Samples> statsInTurns(const BenchOptions& options, int rounds,
                                  const std::vector<std::string>& arguments,
                                  const std::string& label);

}  // namespace bench
