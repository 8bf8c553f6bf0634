// A table of commands: pictures, and the arguments of raytracer that give them.
#pragma once
#include <string>
#include <vector>

#include "cli/request.h"

/// A line of the table. Its words are separated by blanks; ' or " keep blanks in a word that they
/// stand in; # at the start of a word begins a comment.
///   PICTURE ARGUMENT...    e.g.  15_depth.png -input 15_depth.txt -size 200 150 -depth 2 7 d.png
/// PICTURE is what -output would name; - stands for no picture of the colours. Pictures that other
/// arguments name (-depth, -normals) are the line's too. Nothing is written to any of them.
struct TableCommand {
  std::string text;      ///< the arguments, as they stand in the table
  RenderRequest render;  ///< input files are looked up beside the table
  RunRequest run;
};

/// Reads a table. What its lines do not say of their runs is as in `defaults`. Throws ImageError
/// where the file cannot be read, UsageError "FILE:LINE: ..." for a mistake: arguments that the
/// program would refuse, those that only print (-check, -stats, -help) or compare, a line without a
/// picture, a picture that an earlier line has too.
std::vector<TableCommand> readCommandTable(const std::string& path, const RunRequest& defaults);
