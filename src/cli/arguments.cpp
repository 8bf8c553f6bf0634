// The table of all arguments, read from the list that `raytracer -help` prints; and reading the
// words that follow an argument.
//
// In the list a line at the left is the heading of a group. An argument stands two columns further
// right, with the names of its words in capitals, perhaps a second spelling behind a comma, and
// what it does, which goes on in lines that begin further right. So what is told of an argument, in
// any text, and how many words the parser takes for it cannot differ. What each argument does is
// looked up by its name in argument_actions.cpp.
//
// A number must fill its whole word and lie within its limits; a message names the argument, says
// what was expected, and shows the word as it was found.
#include "cli/arguments.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "image/picture_file.h"
#include "scene/number_reader.h"

namespace {

constexpr const char* kList = R"(Reading:
  -input FILE            scene to read (needed but for -compare and -merge); -
                         is standard input
  -course COURSE         the year of the course whose rules and defaults hold;
                         what is given besides wins (default: 2003)

Pictures:
  -output FILE           image to write; the ending picks the format: .tga,
                         .png, .bmp, .ppm or .pfm, and the course's where it is
                         missing, which is TGA unless -course says otherwise; so
                         it does for the other images; - is standard output, for
                         one image of a run
  -size W H              image size, 1 to 65535 pixels each (default: 100 100)
  -depth MIN MAX FILE    write the depth image, white at distance MIN and black
                         at MAX (2016, 2020: the other way round); FILE MIN MAX,
                         where FILE does not look like a number, means the same
  -normals FILE, -normal FILE
                         write the normal image: red, green, blue are |x|, |y|,
                         |z| of the surface normal (2016, 2020: (x + 1) / 2 and
                         so on)
  -materials FILE        write a picture with a colour for each material, and
                         print which is which
  -heatmap FILE          write a picture of how many rays each pixel takes, and
                         print its scale

Tracing:
  -bounces N             the most mirror or refracted rays in a row, 0 (none) to
                         10000 (default: 5)
  -weight W              mirror and refracted rays whose part in the pixel would
                         be below W are not traced; W is at least 0 (default:
                         0.01)
  -epsilon E             how far from its origin a secondary or shadow ray
                         starts looking: a number of at least 0; course, which
                         is 0.001 (0.01 in 2016 and 2020); or adaptive, from the
                         size of the numbers at the hit (default: course where
                         the bounded objects together span 1 to 1000 units and
                         no glass is thinner than that, else adaptive)

Samples in a pixel:
  -random_samples N      N rays at random places in each pixel, 1 to 65536
  -uniform_samples N     N rays in each pixel, at the centres of a square grid;
                         N is rounded up to a square (aalto: at random places)
  -regular_samples N     the same, at the centres of a square grid in any course
  -jittered_samples N    N rays in each pixel, one at random in each cell of
                         such a grid
  -adaptive_samples MIN MAX TOLERANCE
                         MIN jittered rays in each pixel, 1 to 256, and up to
                         MAX where colours differ by more than TOLERANCE, 0 to 1
  -box_filter R          a pixel is the mean of the samples up to R pixels to
                         each side of its centre; R is above 0 and up to 32
                         (default: 0.5)
  -tent_filter R         samples at distance d count 1 - d / R, up to R pixels
                         away; R is up to 32
  -gaussian_filter SIGMA samples at distance d count exp(-d^2 / (2 SIGMA^2)), up
                         to 2 SIGMA pixels away; SIGMA is up to 16
  -render_samples FILE ZOOM
                         write a picture of the samples, each a dot of its
                         colour, ZOOM times as large as the image
  -render_filter FILE ZOOM
                         write a picture of the filter's weights for the middle
                         pixel, ZOOM times as large as the image

Shadows and materials:
  -shadows               cast shadow rays (default: on)
  -no_shadows            cast no shadow rays
  -transparent_shadows   transparent objects tint and dim the light instead of
                         blocking it
  -shade_back            light both sides of every surface
  -nested_dielectrics    the index of refraction on either side follows from
                         what a ray has entered and not left; where objects
                         overlap, the larger priority of their materials holds
  -specular_fix          highlights are dimmed by the angle of the light as
                         diffuse light is
  -fresnel               how much is reflected follows from index and angle;
                         glass dims with the length inside

Large pictures:
  -region X Y W H        render W x H pixels only, of which the first is X from
                         the left and Y from the top; the images are parts, for
                         -merge
  -tile I N              render the I-th of N bands of rows only, counted from 1
                         at the top; N is at most the image's height
  -merge OUT PART...     a run of its own, without -input: put an image together
                         from all its parts, TGA files in any order
  -checkpoint FILE       keep finished tiles of the picture in FILE, from which
                         the same command takes up after the program was ended;
                         FILE is removed when the picture is done
  -memory_limit MB       end the run with a message rather than take more than
                         so many megabytes of memory (2^20 bytes each), 1 to
                         100000000 (default: no limit)

Speed:
  -threads N             worker threads, 1 to 1024; the image never depends on
                         it (default: all cores)
  -accel NAME            fast, or tree: the plain object tree, for checking
                         (default: fast)
  -grid NX NY NZ         find hits through a uniform grid of so many cells, 1 to
                         1024 along each axis and at most 16777216 in all, in
                         place of -accel; the image never depends on it
  -simd LEVEL            instruction set: auto, baseline, avx2 or avx512; where
                         the processor lacks it, the next best; the image never
                         depends on it (default: auto)

Comparing (a run of its own, without -input):
  -compare EXPECTED ACTUAL
                         tell how far two pictures are apart, or all those of
                         two folders, or those of a folder and the ones that a
                         table of commands gives
  -tolerance N           differences of up to N of 255 levels do not count
                         (default: 1)
  -fail_percent P        up to P percent of the pixels may differ by more
                         (default: 0)
  -diff FILE             write a picture of the differences of two pictures, 16
                         times as large
  -report FILE           write an HTML page with all pictures, the worst first
  -csv FILE              add a row for each pair of pictures to a table of
                         comma-separated values

Looking inside:
  -check                 render nothing: read the scene and its meshes and
                         report every mistake
  -stats                 print what was used and how long it took, in lines of
                         NAME: VALUE
  -pixel X Y             print all rays of one pixel, counted from the top left,
                         and what becomes of them
  -pixel_obj FILE        with -pixel: write the same rays as lines of an OBJ
                         file
  -visualize_grid        draw the cells of -grid that hold any object as white
                         boxes
  -visualize_grid_count  the same in colours, from white for one object in a
                         cell to red for more than 32

Of the pages of 2012, 2016 and 2020 alone:
  -jitter                nine rays in each pixel, one at random in each cell of
                         a picture three times as wide and high
  -filter                with -jitter: blur that picture before the nine are
                         averaged

Of the pages of 2004 alone:
  -gui                   accepted without effect: no window is opened
  -gouraud               the same
  -tessellation A B      the same

Information:
  -progress              tell on standard error how far the picture is, even
                         where that is no terminal
  -preview               show the picture on standard output, in coloured
                         characters as large as the window; on a terminal from
                         the first tile on
  -quiet                 no warnings, no progress
  -help [TOPIC], -h [TOPIC]
                         print this list, or what is to be known of one of the
                         topics at its end
  -version               print the version
  -man                   print the manual page, to be read with man -l -
  -completion            print a script for bash, which then completes arguments
)";

/// Reads "depth MIN MAX FILE", or "normals FILE, -normal FILE", where both have the same words.
ArgumentRow readHeading(const std::string& group, const std::string& heading) {
  const auto nameOf = [](const std::string& text) { return text.substr(0, text.find(' ')); };
  const std::size_t comma = heading.find(", -");
  const std::string first = heading.substr(0, comma);
  ArgumentRow row;
  row.group = group;
  row.name = nameOf(first);
  for (std::size_t blank = first.find(' '); blank != std::string::npos; ++row.mostWords) {
    const std::size_t end = first.find(' ', blank + 1);
    const std::string word = first.substr(blank + 1, end - blank - 1);
    row.words += (row.words.empty() ? "" : " ") + word;
    row.wordNames.push_back(word);
    row.leastWords += word[0] != '[';
    blank = end;
  }
  if (row.words.find("...") != std::string::npos) row.mostWords = std::string::npos;
  if (comma != std::string::npos) row.otherName = nameOf(heading.substr(comma + 3));
  row.action = &actionOf(row.name);
  return row;
}

/// Where the heading at the start of a line ends: the text behind it begins with a small letter, or
/// stands further right.
std::size_t headingEnd(const std::string& line) {
  const auto isInHeading = [](char c) {
    return c != ' ' && !std::islower(static_cast<unsigned char>(c));
  };
  std::size_t end = line.find(' ', 2);
  while (end < line.size() && isInHeading(line[end + 1])) end = line.find(' ', end + 1);
  return std::min(end, line.size());
}

std::vector<ArgumentRow> readRows() {
  std::vector<ArgumentRow> rows;
  std::string group;
  std::istringstream lines(kList);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (line[0] != ' ') {
      group = line.substr(0, line.size() - 1);
      continue;
    }
    if (line[2] == '-') {
      const std::size_t end = headingEnd(line);
      rows.push_back(readHeading(group, line.substr(3, end - 3)));
      line.erase(0, end);
    }
    std::string& help = rows.back().help;
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin != std::string::npos) help += (help.empty() ? "" : " ") + line.substr(begin);
  }
  return rows;
}

}  // namespace

std::string optionList() { return kList; }

const std::vector<ArgumentRow>& argumentTable() {
  static const std::vector<ArgumentRow> table = readRows();
  return table;
}

const ArgumentRow* findArgument(const std::string& name) {
  for (const ArgumentRow& row : argumentTable()) {
    if (!name.empty() && (name == row.name || name == row.otherName)) return &row;
  }
  return nullptr;
}

void ArgumentWords::fail(std::size_t index, const std::string& expected) const {
  failUsage("-", row_.name, ": expected ", expected, ", found ", ::quoted(words_[index]));
}

/// The message has the limits and what the table calls the word.
int ArgumentWords::integer(std::size_t index, int least, int most) const {
  int value = 0;
  if (readInt(words_[index], value) && value >= least && value <= most) return value;
  fail(index, joined("a whole number from ", least, " to ", most, " for ", row_.wordNames[index]));
}

/// `expected` names the limits, which are numbers of another kind each time.
double ArgumentWords::number(std::size_t index, double least, double most,
                             const std::string& expected) const {
  double value = 0;
  if (!readNumber(words_[index], value) || value < least || value > most) fail(index, expected);
  return value;
}

/// What looks like a number but is too large, 1e999, is told apart from what is none.
double ArgumentWords::anyNumber(std::size_t index, const std::string& what) const {
  double value = 0;
  if (readNumber(words_[index], value)) return value;
  fail(index, (isNumber(words_[index]) ? "a number within range for " : "a number for ") + what);
}

/// All choices are in the message.
std::size_t ArgumentWords::choice(bool proposes) const {
  const WordList choices = row_.action->choices;
  const auto found = std::find(choices.begin(), choices.end(), words_[0]);
  if (found != choices.end()) return std::size_t(found - choices.begin());
  const std::string nearest(proposes ? nearestWord(words_[0], choices) : "");
  failUsage("-", row_.name, ": expected ", listed(choices), ", found ", ::quoted(words_[0]),
            nearest.empty() ? "" : "; did you mean " + ::quoted(nearest) + "?");
}

const std::string& ArgumentWords::notEmpty(std::size_t index, const char* expected) const {
  if (words_[index].empty()) fail(index, expected);
  return words_[index];
}

const std::string& ArgumentWords::picture(std::size_t index) const {
  const std::string& name = file(index);
  if (!formatOf(name)) {
    std::string endings;
    for (const char* const ending : kPictureEndings) {
      endings += std::string(endings.empty() ? "." : ", .") + ending;
    }
    fail(index, "a file name without ending or with one of " + endings);
  }
  return name;
}
