// The texts that are made from the table of arguments and the topics of help: the lists of the
// help, the manual page in the macros of man(7), and the script with which bash completes a command
// line.
//
// The manual page has the arguments as paragraphs with hanging tags, group by group, and then every
// topic as a section. The script holds the names of all arguments and, for each that takes words,
// what can be offered in the place of each of them; a shell function walks along the line with
// that.
#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include "cli/arguments.h"

namespace {

constexpr const char* kVersion = "1.0";
constexpr const char* kManualDate = "2026-11-22";
constexpr const char* kStart = R"(raytracer: renders a scene file to an image, for example
  raytracer -input scene.txt -output out.tga -bounces 5 -weight 0.01
)";
constexpr const char* kForms =
    R"(Arguments come in any order, with one dash or two; the last of two equal ones
wins. A word may follow behind =, and a size have an x: -bounces=5 -size 64x48.
)";
constexpr const char* kHelpBegin =
    R"(-input, -compare or -merge is needed, and with -input at least one of -output,
-depth, -normals, -render_samples, -render_filter, -materials, -heatmap,
-pixel, -preview, -stats and -check.

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
constexpr std::size_t kTextColumn = 25;   // where the text about a group begins
constexpr std::size_t kTopicColumn = 14;  // likewise about a topic
constexpr std::size_t kWidth = 80;

/// `text` so that troff shows it letter by letter: a minus sign stays one, and no line begins with
/// a control character.
std::string forTroff(const std::string& text) {
  constexpr std::string_view kSpecial = "-\\'^~";
  constexpr const char* kEscapes[] = {"\\-", "\\e", "\\(aq", "\\(ha", "\\(ti"};
  std::string result = !text.empty() && text[0] == '.' ? "\\&" : "";
  for (const char c : text) {
    const std::size_t special = kSpecial.find(c);
    result += special < kSpecial.size() ? kEscapes[special] : std::string(1, c);
  }
  return result;
}

/// An argument in bold and its words in italics.
std::string spelling(const std::string& name, const ArgumentRow& row) {
  const std::string words = row.words.empty() ? "" : " \\fI" + forTroff(row.words) + "\\fR";
  return "\\fB\\-" + forTroff(name) + "\\fR" + words;
}

/// The section about all arguments, its groups as subsections.
std::string entries() {
  std::string text, group;
  for (const ArgumentRow& row : argumentTable()) {
    if (group != row.group) text += ".SS " + forTroff(row.group) + "\n";
    group = row.group;
    text += ".TP\n" + spelling(row.name, row);
    if (!row.otherName.empty()) text += ", " + spelling(row.otherName, row);
    text += "\n" + forTroff(row.help) + ".\n";
  }
  return text;
}

/// In capitals.
bool isHeading(const std::string& line) {
  return std::none_of(line.begin(), line.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

/// A topic as a section: headings become subsections, other lines at the left paragraphs, and
/// indented lines stay as they are.
std::string topicSection(const HelpTopic& topic) {
  std::string text = topic.name;
  for (char& c : text) c = char(std::toupper(static_cast<unsigned char>(c)));
  text = ".SH " + text + "\n";
  std::istringstream lines(topic.text);
  bool isExample = false, isNewParagraph = false;
  for (std::string line; std::getline(lines, line);) {
    // An example ends where a line begins at the left; paragraphs begin there and after an empty
    // line.
    const bool wasExample = std::exchange(isExample, line.compare(0, 2, "  ") == 0);
    if (wasExample && !isExample) text += ".EE\n";
    isNewParagraph = isNewParagraph || line.empty() || (wasExample && !isExample);
    if (line.empty()) continue;
    text += !isExample && isHeading(line) ? ".SS " : isNewParagraph ? ".PP\n" : "";
    if (isExample && !wasExample) text += ".EX\n";
    text += forTroff(line) + "\n";
    isNewParagraph = false;
  }
  return text + (isExample ? ".EE\n" : "");
}

/// Names that the table gives to words which are files or folders.
constexpr std::string_view kFileWords[] = {"FILE", "OUT", "PART...", "EXPECTED", "ACTUAL"};

/// What may follow the argument, word by word: "file", choices joined by strokes, or "-" where
/// nothing can be offered. Three dots behind a word say that it may come again, a question mark
/// that it may be left out.
std::string offers(const ArgumentRow& row) {
  std::string text, choices;
  for (const std::string_view choice : row.action->choices) {
    choices += (choices.empty() ? "" : "/") + std::string(choice);
  }
  for (const std::string& word : row.wordNames) {
    const bool mayRepeat = word.find("...") != std::string::npos;
    const std::string offer = !choices.empty() ? choices : isOneOf(word, kFileWords) ? "file" : "-";
    text += (text.empty() ? "" : " ") + offer + (mayRepeat ? "..." : word[0] == '[' ? "?" : "");
    choices.clear();
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
  std::string text = kStart, group, line;
  for (const ArgumentRow& row : argumentTable()) {
    const std::string name = " -" + row.name;
    // A line ends where a group does, and where the next name would pass the last column.
    const bool isFirst = group != row.group;
    if (isFirst || line.size() + name.size() > kWidth) {
      text += line + "\n";
      line = isFirst ? "  " + row.group : "";
      if (line.size() >= kTextColumn) text += std::exchange(line, "") + "\n";
      line.resize(kTextColumn - 1, ' ');
    }
    group = row.group;
    line += name;
  }
  return text + line +
         "\n\n'raytracer -help' explains them all, 'raytracer -help scene' the scene files.\n";
}

std::string fullHelp() {
  return std::string(kStart) + kForms + kHelpBegin + optionList() + kHelpEnd + topicList();
}

std::string versionText() { return std::string("raytracer ") + kVersion; }

std::string manPage() {
  std::string topics;
  for (const HelpTopic& topic : helpTopics()) topics += topicSection(topic);
  return ".\\\" Made from the table of arguments by 'raytracer -man'.\n.TH RAYTRACER 1 " +
         std::string(kManualDate) + " \"" + versionText() + "\" \"User Commands\"\n" + kSynopsis +
         forTroff(kForms) + entries() + kManualEnd + topics;
}

std::string completionScript() {
  std::string names, cases;
  for (const ArgumentRow& row : argumentTable()) {
    const std::string& other = row.otherName;
    names += "  " + row.name + (other.empty() ? "" : " " + other) + "\n";
    if (row.words.empty()) continue;
    cases += "    " + row.name + (other.empty() ? "" : "|" + other) + ") offers=(" + offers(row) +
             ") ;;\n";
  }
  return "# bash completion for raytracer, made from its table of arguments.\n\n"
         "_raytracer_names='\n" +
         names + "'\n\n# What may follow the argument $1, word by word.\n" +
         "_raytracer_offers() {\n  case $1 in\n" + cases + "    *) offers=() ;;\n  esac\n}\n" +
         kRest;
}
