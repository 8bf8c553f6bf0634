// The manual page, in the macros of man(7), made from the table of arguments.
#include <algorithm>
#include <cctype>

#include "cli/arguments.h"

namespace {

/// Of the texts below; the page's date.
constexpr const char* kDate = "2026-11-22";

/// `text` so that troff shows it letter by letter: a minus sign stays one, and no line begins with
/// a control character.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '-') {
      result += "\\-";
    } else if (c == '\\') {
      result += "\\e";
    } else if (c == '\'') {
      result += "\\(aq";
    } else {
      result += c;
    }
  }
  return !text.empty() && text[0] == '.' ? "\\&" + result : result;
}

std::string section(const std::string& name) { return ".SH " + name + "\n"; }

/// An argument in bold and its words in italics.
std::string spelling(const char* name, const ArgumentRow& row) {
  const std::string words = *row.words ? " \\fI" + escaped(row.words) + "\\fR" : "";
  return "\\fB\\-" + escaped(name) + "\\fR" + words;
}

std::string entry(const ArgumentRow& row) {
  std::string text = ".TP\n" + spelling(row.name, row);
  if (row.otherName) text += ", " + spelling(row.otherName, row);
  text += "\n" + escaped(row.help);
  if (row.defaultWords) text += " (default: " + escaped(row.defaultWords) + ")";
  return text + ".\n";
}

std::string entries() {
  std::string text, group;
  for (const ArgumentRow& row : argumentTable()) {
    if (group != row.group) text += ".SS " + escaped(row.group) + "\n";
    group = row.group;
    text += entry(row);
  }
  return text;
}

std::string description() {
  return section("DESCRIPTION") +
         escaped(
             "Reads a scene (a camera, lights, materials, spheres, planes, triangles, meshes and\n"
             "transformations) and renders it with shadows, mirrors and refraction. The image\n"
             "depends on the scene and the options alone, not on the machine or the number of\n"
             "threads. The README that comes with the program describes scene files.\n");
}

std::string exitStatus() {
  const char* const kMeanings[] = {"done", "an output failed, or memory ran out", "wrong usage",
                                   "the scene or a mesh is at fault"};
  std::string text = section("EXIT STATUS");
  int status = 0;
  for (const char* meaning : kMeanings) {
    text += ".TP\n.B " + std::to_string(status++) + "\n" + escaped(meaning) + ".\n";
  }
  return text;
}

}  // namespace

std::string manPage() {
  return ".\\\" Made from the table of arguments by 'raytracer -man'.\n.TH RAYTRACER 1 " +
         std::string(kDate) + " \"" + versionText() + "\" \"User Commands\"\n" + section("NAME") +
         "raytracer \\- render a scene file to an image\n" + section("SYNOPSIS") +
         ".B raytracer \\-input\n.I scene.txt\n.B \\-output\n.I out.tga\n"
         ".RI [ option \" ...]\"\n" +
         description() + section("OPTIONS") +
         escaped(
             "Options come in any order, with one dash or two; the last of two equal ones\n"
             "wins.\n") +
         entries() + exitStatus() + section("EXAMPLES") + ".EX\n" +
         escaped(
             "raytracer -input scene.txt -output out.tga -bounces 5 -weight 0.01\n"
             "raytracer -input scene.txt -check\n") +
         ".EE\n";
}
