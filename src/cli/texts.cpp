// The texts that are made from the table of arguments: the lists of the help, the manual page in
// the macros of man(7), and the script with which bash completes a command line.
#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "cli/arguments.h"
#include "cli/help_topics.h"

namespace {

constexpr const char* kVersion = "1.0";
constexpr const char* kManualDate = "2026-11-22";
constexpr const char* kStart = R"(raytracer: renders a scene file to an image, for example
  raytracer -input scene.txt -output out.tga -bounces 5 -weight 0.01
)";
constexpr const char* kHelpBegin =
    R"(Arguments come in any order, with one dash or two; the last of two equal ones
wins. -input, -compare or -merge is needed, and with -input at least one of
-output, -depth, -normals, -render_samples, -render_filter, -materials,
-heatmap, -pixel, -preview, -stats and -check.

)";
constexpr const char* kHelpEnd = R"(
Exit status: 0 done, 1 an output failed, 2 wrong usage, 3 the scene or a mesh
is at fault. Of -compare: 0 the same, 1 different, 2 wrong usage, 3 unreadable.
Of -merge: 3 a part is at fault or missing.

'raytracer -help TOPIC' tells more; the topics are
)";
constexpr const char* kSynopsis = R"(.SH NAME
raytracer \- render a scene file to an image
.SH SYNOPSIS
.B raytracer \-input
.I scene.txt
.B \-output
.I out.tga
.RI [ option " ...]"
.SH DESCRIPTION
Reads a scene (a camera, lights, materials, spheres, planes, triangles, meshes and
transformations) and renders it with shadows, mirrors and refraction. The image
depends on the scene and the options alone, not on the machine or the number of
threads. The sections SCENE to LIMITS are the topics of \(aqraytracer \-help TOPIC\(aq.
.SH OPTIONS
Options come in any order, with one dash or two; the last of two equal ones
wins.
)";
constexpr const char* kManualEnd = R"(.SH EXIT STATUS
.TP
.B 0
done.
.TP
.B 1
an output failed, or memory ran out.
.TP
.B 2
wrong usage.
.TP
.B 3
the scene or a mesh is at fault.
.SH EXAMPLES
.EX
raytracer \-input scene.txt \-output out.tga \-bounces 5 \-weight 0.01
raytracer \-input scene.txt \-check
.EE
)";
constexpr std::size_t kTextColumn = 25;   // where the text about an argument begins
constexpr std::size_t kTopicColumn = 14;  // likewise about a topic
constexpr std::size_t kWidth = 80;

/// Appends `text` to `list`, whose last line has `column` columns, broken at blanks so that every
/// line starts at kTextColumn and ends by kWidth.
void appendWrapped(std::string& list, std::size_t column, const std::string& text) {
  if (column + 1 > kTextColumn) {
    list += '\n';
    column = 0;
  }
  list.append(kTextColumn - column, ' ');
  std::size_t start = 0;
  while (text.size() - start > kWidth - kTextColumn) {
    const std::size_t end = text.rfind(' ', start + kWidth - kTextColumn);
    list += text.substr(start, end - start) + "\n" + std::string(kTextColumn, ' ');
    start = end + 1;
  }
  list += text.substr(start) + "\n";
}

std::string heading(const ArgumentRow& row) {
  const std::string words = *row.words ? std::string(" ") + row.words : "";
  std::string text = std::string("  -") + row.name + words;
  if (row.otherName) text += std::string(", -") + row.otherName + words;
  return text;
}

/// `text` so that troff shows it letter by letter: a minus sign stays one, and no line begins with
/// a control character.
std::string forTroff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '-') {
      result += "\\-";
    } else if (c == '\\') {
      result += "\\e";
    } else if (c == '\'') {
      result += "\\(aq";
    } else if (c == '^') {
      result += "\\(ha";
    } else if (c == '~') {
      result += "\\(ti";
    } else {
      result += c;
    }
  }
  return !text.empty() && text[0] == '.' ? "\\&" + result : result;
}

/// An argument in bold and its words in italics.
std::string spelling(const char* name, const ArgumentRow& row) {
  const std::string words = *row.words ? " \\fI" + forTroff(row.words) + "\\fR" : "";
  return "\\fB\\-" + forTroff(name) + "\\fR" + words;
}

std::string entry(const ArgumentRow& row) {
  std::string text = ".TP\n" + spelling(row.name, row);
  if (row.otherName) text += ", " + spelling(row.otherName, row);
  text += "\n" + forTroff(helpOf(row));
  return text + ".\n";
}

std::string entries() {
  std::string text, group;
  for (const ArgumentRow& row : argumentTable()) {
    if (group != row.group) text += ".SS " + forTroff(row.group) + "\n";
    group = row.group;
    text += entry(row);
  }
  return text;
}

bool isHeading(const std::string& line) {
  return std::none_of(line.begin(), line.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

/// A topic as a section: headings become subsections, other lines at the left paragraphs, and
/// indented lines stay as they are.
std::string topicSection(const HelpTopic& topic) {
  std::string text = ".SH ";
  for (const char* c = topic.name; *c; ++c) {
    text += char(std::toupper(static_cast<unsigned char>(*c)));
  }
  text += '\n';
  std::istringstream lines(topic.text);
  bool isExample = false, isNewParagraph = false;
  for (std::string line; std::getline(lines, line);) {
    const bool isIndented = line.compare(0, 2, "  ") == 0;
    if (isExample && !isIndented) {
      text += ".EE\n";
      isNewParagraph = true;
    }
    if (line.empty()) {
      isNewParagraph = true;
    } else if (!isIndented && isHeading(line)) {
      text += ".SS " + forTroff(line) + "\n";
      isNewParagraph = false;
    } else {
      if (isNewParagraph) text += ".PP\n";
      if (isIndented && !isExample) text += ".EX\n";
      text += forTroff(line) + "\n";
      isNewParagraph = false;
    }
    isExample = isIndented;
  }
  return text + (isExample ? ".EE\n" : "");
}

/// Names that the table gives to words which are files or folders.
bool isFile(const std::string& word) {
  for (const char* part : {"FILE", "OUT", "PART", "EXPECTED", "ACTUAL", "FOLDER"}) {
    if (word.find(part) != std::string::npos) return true;
  }
  return false;
}

/// What may follow the argument, word by word: "file", choices joined by strokes, or "-" where
/// nothing can be offered. Three dots behind a word say that it may come again, a question mark
/// that it may be left out.
std::string offers(const ArgumentRow& row) {
  std::string text, choices = row.choices;
  std::replace(choices.begin(), choices.end(), ' ', '/');
  std::istringstream words(row.words);
  for (std::string word; words >> word; choices.clear()) {
    const bool mayRepeat = word.size() > 3 && word.compare(word.size() - 3, 3, "...") == 0;
    const std::string offer = !choices.empty() ? choices : isFile(word) ? "file" : "-";
    const char* const mark = mayRepeat ? "..." : word[0] == '[' ? "?" : "";
    text += (text.empty() ? "" : " ") + offer + mark;
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
    if [[ ${#offers[@]} -gt 0 && ! (${offers[0]} == *[.?] && $word == -*) ]]; then
      [[ ${offers[0]} == *... ]] || offers=("${offers[@]:1}")
    else
      word=${word#-}
      _raytracer_offers "${word#-}"
    fi
  done
  [[ ${offers[0]-} == *[.?] && $current == -* ]] && offers=()
  COMPREPLY=()
  case ${offers[0]-} in
    file*)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
    -*) ;;
    ?*)
      offers[0]=${offers[0]%\?}
      mapfile -t COMPREPLY < <(compgen -W "${offers[0]//\// }" -- "$current") ;;
    *)
      [[ $current == --* ]] && dash=--
      mapfile -t COMPREPLY < <(compgen -P "$dash" -W "$_raytracer_names" -- "${current#"$dash"}") ;;
  esac
}

complete -F _raytracer raytracer
)";

}  // namespace

std::string optionList() {
  std::string list, group;
  for (const ArgumentRow& row : argumentTable()) {
    if (group != row.group) list += (group.empty() ? "" : "\n") + std::string(row.group) + ":\n";
    group = row.group;
    const std::string left = heading(row);
    list += left;
    appendWrapped(list, left.size(), helpOf(row));
  }
  return list;
}

std::string topicList() {
  std::string list;
  for (const HelpTopic& topic : helpTopics()) {
    std::string line = std::string("  ") + topic.name;
    line.resize(kTopicColumn, ' ');
    list += line + topic.summary + "\n";
  }
  return list;
}

std::string shortHelp() {
  std::string text = kStart;
  const std::vector<ArgumentRow>& table = argumentTable();
  for (auto row = table.begin(); row != table.end();) {
    const std::string group = row->group;
    std::string names;
    for (; row != table.end() && group == row->group; ++row) {
      names += (names.empty() ? "-" : " -") + std::string(row->name);
    }
    text += "\n  " + group;
    appendWrapped(text, group.size() + 2, names);
    text.pop_back();
  }
  return text +
         "\n\n'raytracer -help' explains them all, 'raytracer -help scene' the scene files.\n";
}

std::string fullHelp() {
  return std::string(kStart) + kHelpBegin + optionList() + kHelpEnd + topicList();
}

std::string versionText() { return std::string("raytracer ") + kVersion; }

std::string manPage() {
  std::string topics;
  for (const HelpTopic& topic : helpTopics()) topics += topicSection(topic);
  return ".\\\" Made from the table of arguments by 'raytracer -man'.\n.TH RAYTRACER 1 " +
         std::string(kManualDate) + " \"" + versionText() + "\" \"User Commands\"\n" + kSynopsis +
         entries() + kManualEnd + topics;
}

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
