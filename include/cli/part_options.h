// Which part of a picture is rendered, and what is merged.
#pragma once
#include <string>
#include <vector>

struct PartOptions {
  bool isRegion = false;                    ///< -region: x, y, width and height are given
  int x = 0, y = 0, width = 0, height = 0;  ///< in pixels, from the top left corner
  int tile = 0, tiles = 0;                  ///< -tile: number tile, from 1, of tiles; 0: not given
  bool isWanted() const { return isRegion || tiles > 0; }
};

struct MergeOptions {
  std::string output;
  std::vector<std::string> parts;
  bool isWanted() const { return !parts.empty(); }
};
