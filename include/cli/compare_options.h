// What `raytracer -compare` is asked to do.
#pragma once
#include <string>

struct CompareOptions {
  std::string expected;    ///< a picture or a folder; empty: nothing is compared
  std::string actual;      ///< a picture, a folder, or a table of commands (see command_table.h)
  int tolerance = 1;       ///< levels, 0..255: differences up to it do not count
  double failPercent = 0;  ///< pictures are different when more of their pixels than this differ
  std::string diff;        ///< picture of the differences; empty = not wanted, as for the others
  std::string report;      ///< HTML page
  std::string csv;         ///< table that rows are added to

  bool isWanted() const { return !expected.empty(); }
};
