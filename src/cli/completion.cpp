// The script with which bash completes a command line, made from the table of arguments.
#include <algorithm>
#include <sstream>

#include "cli/arguments.h"

namespace {

/// Names that the table gives to words which are files or folders.
bool isFile(const std::string& word) {
  for (const char* part : {"FILE", "OUT", "PART", "EXPECTED", "ACTUAL", "FOLDER"}) {
    if (word.find(part) != std::string::npos) return true;
  }
  return false;
}

/// What may follow the argument, word by word: "file", choices joined by strokes, or "-" where
/// nothing can be offered. Three dots behind a word say that it may come again.
std::string offers(const ArgumentRow& row) {
  std::string text, choices = row.choices;
  std::replace(choices.begin(), choices.end(), ' ', '/');
  std::istringstream words(row.words);
  for (std::string word; words >> word; choices.clear()) {
    const bool mayRepeat = word.size() > 3 && word.compare(word.size() - 3, 3, "...") == 0;
    const std::string offer = !choices.empty() ? choices : isFile(word) ? "file" : "-";
    text += (text.empty() ? "" : " ") + offer + (mayRepeat ? "..." : "");
  }
  return text;
}

constexpr const char* kRest = R"(
# Walks along the line up to the word that is being typed, to see what it is part of.
_raytracer() {
  local current=${COMP_WORDS[COMP_CWORD]} dash=- word i
  local -a offers=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if [[ ${#offers[@]} -gt 0 && ! (${offers[0]} == *... && $word == -*) ]]; then
      [[ ${offers[0]} == *... ]] || offers=("${offers[@]:1}")
    else
      word=${word#-}
      _raytracer_offers "${word#-}"
    fi
  done
  [[ ${offers[0]-} == *... && $current == -* ]] && offers=()
  COMPREPLY=()
  case ${offers[0]-} in
    file*)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    -*) ;;
    ?*) mapfile -t COMPREPLY < <(compgen -W "${offers[0]//\// }" -- "$current") ;;
    *)
      [[ $current == --* ]] && dash=--
      mapfile -t COMPREPLY < <(compgen -P "$dash" -W "$_raytracer_names" -- "${current#"$dash"}") ;;
  esac
}

complete -F _raytracer raytracer
)";

}  // namespace

std::string completionScript() {
  std::string names, cases;
  for (const ArgumentRow& row : argumentTable()) {
    const std::string other = row.otherName ? row.otherName : "";
    names += "  " + std::string(row.name) + (other.empty() ? "" : " " + other) + "\n";
    const std::string offered = offers(row);
    if (offered.empty()) continue;
    cases.append("    ").append(row.name).append(other.empty() ? "" : "|" + other);
    cases.append(") offers=(").append(offered).append(") ;;\n");
  }
  return "# bash completion for raytracer, made from its table of arguments.\n\n"
         "_raytracer_names='\n" +
         names + "'\n\n# What may follow the argument $1, word by word.\n" +
         "_raytracer_offers() {\n  case $1 in\n" + cases + "    *) offers=() ;;\n  esac\n}\n" +
         kRest;
}
