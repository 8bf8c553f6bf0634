// Command lines in tests: words that parseRequest reads.
#pragma once
#include <algorithm>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/desk.h"

namespace check {

using Words = std::vector<std::string>;

/// Parses a complete command that also has `words`.
inline Request parse(const Words& words) {
  const std::string name =
      words.empty() ? ""
                    : words[0].substr(std::min(words[0].size(), words[0].find_first_not_of('-')));
  const ArgumentRow* row = findArgument(name);
  Words all = {"-input", "scene.txt", "-output", "out.tga"};
  if (row && row->action->mode == ArgumentAction::Mode::comparing) all = {"-compare", "a.tga", "b.tga"};
  if (row && row->action->mode == ArgumentAction::Mode::merging) all.clear();
  all.insert(all.end(), words.begin(), words.end());
  return parseRequest(all);
}

/// The message for a wrong command that begins with `words`; "" where it is right.
inline std::string mistake(const Words& words) {
  try {
    parse(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

inline Words split(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

}  // namespace check
