// Runs of the program on the project's own scenes.
#include "scene_runs.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "process.h"

namespace bench {
namespace {

double statOf(const std::string& program, const std::vector<std::string>& arguments,
              const std::string& label) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  words.push_back("-stats");
  const std::string text = outputOf(words);
  const std::size_t place = text.find(label);
  if (place == std::string::npos) throw std::runtime_error(program + ": no \"" + label + "\"");
  return std::stod(text.substr(place + label.size()));
}

}  // namespace

std::vector<std::string> ownCommand(const std::string& name, const std::string& output,
                                    const std::vector<std::string>& more) {
  const std::string path = std::string(SCENES_FOLDER) + "/" + name + ".txt";
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word && word == "#" && words >> word && word == "raytracer")) continue;
    std::vector<std::string> arguments = {"-input", path, "-output", output};
    while (words >> word) {
      if (word == "-input" || word == "-output") {
        words >> word;
      } else {
        arguments.push_back(word);
      }
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  throw std::runtime_error(path + ": no command in its comment");
}

std::vector<Samples> statsInTurns(const BenchOptions& options, int rounds,
                                  const std::vector<std::string>& arguments,
                                  const std::string& label) {
  std::vector<std::function<double()>> contenders = {
      [&] { return statOf(RAYTRACER_PROGRAM, arguments, label); }};
  if (!options.against.empty()) {
    contenders.push_back([&] { return statOf(options.against, arguments, label); });
  }
  std::vector<Samples> samples = inTurns(rounds, contenders);
  samples.resize(2);
  return samples;
}

}  // namespace bench
