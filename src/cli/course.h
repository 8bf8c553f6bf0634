// Course: the rules of one year of the course. A course is a row of a table: the parser, the
// renderer and the picture of a grid's cells are made from it, and none of them knows its name.
#pragma once
#include <string_view>
#include <vector>

#include "image/picture_file.h"
#include "math/vec3.h"
#include "render/render_options.h"
#include "scene/scene_rules.h"

/// How a cell of a grid is painted that holds at most so many objects; the last one holds for all
/// that have more.
struct CellPaint {
  std::size_t most;
  Vec3f color;
};

/// How the cells of a grid are drawn.
struct CellRules {
  bool areTouched = false;    ///< cells hold what countTouched says, else what countReached does
  bool alwaysCounts = false;  ///< -visualize_grid means -visualize_grid_count
  bool haveShadows = true;    ///< where shadows are cast at all
  std::vector<CellPaint> paints;
};

struct Course {
  std::string_view name;
  /// What holds where no argument says otherwise, and the rules that no argument speaks of.
  RenderOptions render;
  SceneRules scene;
  CellRules cells;
  /// The row that holds instead where the scene has glass, or -bounces says more than 0; or null.
  /// It has the same name and language.
  const Course* withBounces = nullptr;
  PictureFormat format = PictureFormat::tga;  ///< of pictures whose names have no ending
  /// What -uniform_samples asks for; -regular_samples always asks for a grid.
  SamplingOptions::Pattern uniformSamples = SamplingOptions::Pattern::uniform;
  bool isNearBlack = false;       ///< -depth MIN MAX is black at MIN and white at MAX
  bool hasSignedNormals = false;  ///< -normals shows (n + 1) / 2, not |n|
  /// Whether -jitter and -filter, which its pages' commands have, are taken.
  bool hasJitter = false;
  /// Two words without a dash are the scene and the picture.
  bool hasBareFiles = false;
  /// Whether -gui, -gouraud and -tessellation, which its pages' commands have, are taken.
  bool hasWindows = false;
};

/// The names of all courses; the first is the one that holds where none is chosen.
inline constexpr std::string_view kCourseNames[] = {"2003", "2004", "2012", "2016",
                                                    "2020", "thu",  "aalto"};

/// The course of that number among the names, from 0.
const Course& courseAt(std::size_t number);
