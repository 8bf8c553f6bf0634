// What -compare works with. ComparedPair: two pictures that belong together, and what came of
// comparing them (compare_run.cpp); the forms in which that is told: lines of text, a row of
// comma-separated values (compare_text.cpp), a page with the pictures (report_page.cpp).
// TableCommand: a command of a table whose pictures are compared (command_table.cpp).
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "cli/request.h"
#include "image/comparison.h"

struct ComparedPair {
  /// From good to bad.
  enum class Result { same, different, missing, unexpected, unreadable };
  struct Size {
    int width = 0, height = 0;  ///< pixels; 0 where the picture could not be read
    std::string text() const { return sizeText(width, height); }
  };

  std::string name;      ///< what both are called: a path below the folder, where it is one
  std::string expected;  ///< a file; empty where there is none
  std::string actual;    ///< likewise, or a command
  Result result = Result::same;
  std::string fault{};  ///< why it is missing, unexpected or unreadable, or how the sizes differ
  Size expectedSize{}, actualSize{};
  std::optional<Comparison> comparison{};  ///< where both pictures have the same size
  std::string figures{};  ///< the pictures, as they stand in the report, where one is wanted
  Image difference{};     ///< the picture of the differences, where -diff is given

  /// Neither the same within the tolerance nor readable and different.
  bool isAtFault() const { return result != Result::same && result != Result::different; }
};

const char* nameOf(ComparedPair::Result result);

/// What there is to tell of a pair, as far as it could be compared.
struct Figure {
  std::string name, value;
};
std::vector<Figure> figuresOf(const ComparedPair& pair, const CompareRequest& request);

/// The figures of one pair, in lines `name: value`.
std::string figureLines(const ComparedPair& pair, const CompareRequest& request);

/// One line for each pair and one that counts them.
std::string pairLines(const std::vector<ComparedPair>& pairs);

/// Adds a row for each pair to what is in request.csv, a table of comma-separated values (RFC 4180)
/// that begins with our heading unless it is new or empty. Fields that a pair has no value for are
/// empty. Waits for other runs that add to it. Throws OutputError.
void addToCsv(const std::vector<ComparedPair>& pairs, const CompareRequest& request);

/// The pair's pictures as they stand in the report: PNGs in HTML, one where both are equal, else
/// both and that of their differences.
std::string reportFigures(const ReadPicture& expected, const ReadPicture& actual,
                          const ComparedPair& pair);

/// The page: HTML in one file that needs nothing from outside. The worst come first: unreadable or
/// without partner, other sizes, many pixels over the tolerance, a large error; then by name. Names
/// may hold any bytes.
std::string reportPage(std::vector<ComparedPair> pairs, const CompareRequest& request);

// A table of commands: pictures, and the arguments of raytracer that give them.

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
