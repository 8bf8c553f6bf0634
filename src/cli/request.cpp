// Reading the command line: first every argument in turn, then what several of them must fulfil
// together.
//
// An argument takes as many of the words behind it as the table gives it, and enters itself in the
// draft. Only then, as arguments come in any order, is looked at what depends on more than one: the
// mode of the run, what is missing, and all that has to fit the size of the picture. The first
// mistake in this order is the one that is told. At the end the area that is rendered is counted
// from the lower left corner, as the camera counts, and the threads are as many as are used.
#include "cli/request.h"

#include <algorithm>
#include <string_view>

#include "cli/arguments.h"
#include "scene/wording.h"
#include "system/worker_threads.h"

namespace {

using Kind = OutputRequest::Kind;
using Mode = ArgumentAction::Mode;

/// The name in "-name" or "--name"; "" where `word` is not of that form.
std::string nameOf(const std::string& word) {
  if (word.empty() || word[0] != '-') return "";
  return word.substr(word.compare(0, 2, "--") == 0 ? 2 : 1);
}

/// Proposes the argument whose name, or second spelling, is nearest.
[[noreturn]] void failUnknown(const std::string& word) {
  refuseIf(nameOf(word).empty(), "expected an argument such as -input, found ", ::quoted(word));
  std::vector<std::string_view> names;
  for (const ArgumentRow& row : argumentTable()) {
    names.push_back(row.name);
    names.push_back(row.otherName);
  }
  const std::string nearest(nearestWord(nameOf(word), names));
  failUsage(
      "unknown argument ", ::quoted(word), "; ",
      nearest.empty() ? "'raytracer -help' lists them all" : "did you mean '-" + nearest + "'?");
}

/// The command line with --name=word as two words, and -size WxH with its numbers apart.
std::vector<std::string> separated(const std::vector<std::string>& words) {
  std::vector<std::string> all;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    const bool isNamed = equals != word.npos && findArgument(nameOf(word.substr(0, equals)));
    if (isNamed) all.push_back(word.substr(0, equals));
    const std::string value = isNamed ? word.substr(equals + 1) : word;
    const std::size_t x = value.find('x');
    const bool isSize = x != value.npos && !all.empty() && nameOf(all.back()) == "size" &&
                        value.find_first_not_of("0123456789x") == value.npos &&
                        value.find('x', x + 1) == value.npos && x > 0 && x + 1 < value.size();
    all.push_back(isSize ? value.substr(0, x) : value);
    if (isSize) all.push_back(value.substr(x + 1));
  }
  return all;
}

/// The words from words[next] on that are those of the argument `row`: as many as it needs, up to
/// the next argument, and then all that it may have, up to the next word with a dash.
std::vector<std::string> wordsFor(const ArgumentRow& row, const std::vector<std::string>& words,
                                  std::size_t next) {
  std::vector<std::string> found;
  for (const std::size_t first = next; found.size() < row.mostWords; ++next) {
    const bool isEnd = next == words.size();
    const bool isNeeded = found.size() < row.leastWords;
    if (!isNeeded && (isEnd || !nameOf(words[next]).empty())) break;
    if (isEnd || (isNeeded && findArgument(nameOf(words[next]))))
      failUsage(words[first - 1], ": expected ", row.words, ", found ",
                isEnd ? "the end of the command" : ::quoted(words[next]));
    found.push_back(words[next]);
  }
  return found;
}

/// Enters the rules and defaults of a course, before any argument speaks.
void startFrom(const Course& course, Draft& draft) {
  PictureRequest& picture = draft.render.picture;
  picture.course = &course;
  picture.render = course.render;
  picture.rules = course.scene;
}

/// The course that the last -course chooses. A name that is none is told when its turn comes.
const Course& courseOf(const std::vector<std::string>& words) {
  std::size_t number = 0;
  const WordList names(kCourseNames);
  for (std::size_t at = 1; at < words.size(); ++at) {
    const auto found = std::find(names.begin(), names.end(), words[at]);
    if (nameOf(words[at - 1]) == "course" && found != names.end())
      number = std::size_t(found - names.begin());
  }
  return courseAt(number);
}

/// Enters all arguments in `draft`. Of equal arguments the last one wins.
void readArguments(const std::vector<std::string>& words, Draft& draft) {
  std::vector<GivenArgument>& given = draft.render.given;
  std::vector<std::string> bareNames;  // of the arguments that words without a dash stand for
  if (draft.render.picture.course->hasBareFiles) bareNames = {"output", "input"};
  for (std::size_t at = 0; at < words.size();) {
    const bool isBare = nameOf(words[at]).empty() && !words[at].empty() && !bareNames.empty();
    const ArgumentRow* row = findArgument(isBare ? bareNames.back() : nameOf(words[at]));
    if (!row) failUnknown(words[at]);
    if (isBare) bareNames.pop_back();
    const std::size_t first = at + (isBare ? 0 : 1);
    const GivenArgument argument = {row->name, wordsFor(*row, words, first)};
    row->action->apply(ArgumentWords(*row, argument.words), draft);
    const auto isSame = [&](const GivenArgument& other) { return other.name == row->name; };
    given.erase(std::remove_if(given.begin(), given.end(), isSame), given.end());
    given.push_back(argument);
    at = first + argument.words.size();
  }
}

/// -compare and -merge are modes of their own: what only renders has no place beside them, nor the
/// other way round.
void checkMode(const Request& request) {
  // Both may have been given: -compare then counts, and -merge is what does not belong.
  const Mode mode = request.compare.isWanted() ? Mode::comparing
                    : request.merge.isWanted() ? Mode::merging
                                               : Mode::rendering;
  for (const GivenArgument& argument : request.render.given) {
    const Mode wanted = actionOf(argument.name).mode;
    if (wanted == Mode::any || wanted == mode) continue;
    refuseIf(mode == Mode::rendering, "-", argument.name,
             ": expected -compare EXPECTED ACTUAL too, found none");
    failUsage("-", argument.name, " cannot be given together with ",
              mode == Mode::comparing ? "-compare" : "-merge");
  }
}

/// An argument that only `courses` know has been given with one that may be another.
void checkCourse(bool isKnown, const std::string& argument, const char* courses,
                 const Course& course) {
  refuseIf(!isKnown, argument, ": expected -course ", courses, " too, found the course of ",
           course.name);
}

/// What opens a window there.
void takeIdle(Draft& draft) {
  PictureRequest& picture = draft.render.picture;
  if (draft.idle.empty()) return;
  checkCourse(picture.course->hasWindows, draft.idle, "2004", *picture.course);
  picture.notes.push_back("no window is opened: " + draft.idle + " without effect");
}

/// -jitter sends a ray through each cell of a picture kCells times as wide and high, where its
/// pixels would lie; -filter blurs that picture.
void takeJitter(Draft& draft) {
  PictureRequest& picture = draft.render.picture;
  SamplingOptions& sampling = picture.render.sampling;
  if (!draft.isJittered && !draft.isFiltered) return;
  checkCourse(picture.course->hasJitter, draft.isJittered ? "-jitter" : "-filter",
              "2012, 2016 or 2020", *picture.course);
  if (!draft.isJittered) {
    picture.notes.push_back("nothing is filtered: -filter without -jitter has no effect");
    return;
  }
  refuseIf(!sampling.isPlain(), "-jitter cannot be given together with other samples or filters");
  sampling.pattern = SamplingOptions::Pattern::jittered;
  sampling.samples = SamplingOptions::kCells * SamplingOptions::kCells;
  picture.render.places.inset /= SamplingOptions::kCells;
  if (!draft.isFiltered) return;
  sampling.filter = SamplingOptions::FilterKind::blurredCells;
  sampling.hasBorderSamples = false;
}

/// What cannot do without another argument: cells need a grid, and a scene something to be done.
void checkComplete(const Draft& draft) {
  const ResultRequest& results = draft.render.results;
  const Acceleration& acceleration = draft.render.picture.acceleration;
  refuseIf(acceleration.cellPicture != Acceleration::CellPicture::none &&
               acceleration.kind != Acceleration::Kind::grid,
           acceleration.cellPicture == Acceleration::CellPicture::counts ? "-visualize_grid_count"
                                                                         : "-visualize_grid",
           ": expected a grid to draw, for example -grid 20 20 20, found none",
           acceleration.kind == Acceleration::Kind::tree ? " but -accel tree" : "");
  refuseIf(draft.render.picture.scene.empty(), "expected a scene, found no -input FILE");
  refuseIf(results.outputs.empty() && !results.pixel && !results.preview && !results.stats &&
               !draft.check,
           "expected something to do with the scene, found none of -output, -depth, -normals, "
           "-render_samples, -render_filter, -materials, -heatmap, -pixel, -preview, -stats and "
           "-check");
}

/// No picture is enlarged beyond the largest there is. That of a filter has a pixel more.
void checkZooms(const RenderRequest& render) {
  const PictureRequest& picture = render.picture;
  for (const OutputRequest& output : render.results.outputs) {
    const int room = kMaxImageSide - (output.kind == Kind::filter ? 1 : 0);
    const int most = room / std::max(picture.width, picture.height);
    refuseIf(output.zoom > most, output.argument, ": expected a ZOOM of at most ", most,
             " for an image of ", picture.sizeText(), ", found '", output.zoom, "'");
  }
}

/// Whose rays are printed or written must be a pixel of the picture.
void checkPixel(const RenderRequest& render) {
  const PictureRequest& picture = render.picture;
  const auto& pixel = render.results.pixel;
  refuseIf(!pixel && render.results.find(Kind::rays),
           "-pixel_obj: expected a pixel to trace, for example -pixel 50 50, found none");
  if (!pixel || (pixel->x < picture.width && pixel->y < picture.height)) return;
  failUsage("-pixel: expected X below ", picture.width, " and Y below ", picture.height,
            ", the size of the image, found '", pixel->x, " ", pixel->y, "'");
}

/// One part of the picture is wanted, and nothing that has no parts: enlarged pictures are not put
/// together, and what is printed is of the whole.
void checkPart(const Draft& draft) {
  const ResultRequest& results = draft.render.results;
  const std::string name = draft.region ? "-region" : "-tile";
  refuseIf(draft.region && draft.band, "-region and -tile cannot be given together");
  refuseIf(results.find(Kind::samples) || results.find(Kind::filter), name,
           " cannot be given together with -render_samples or -render_filter");
  refuseIf(results.find(Kind::materials) || results.find(Kind::heatmap) || results.pixel, name,
           " cannot be given together with -materials, -heatmap or -pixel");
}

/// Under a limit only so many that their stacks, of 2 MB and more, leave room for the rest.
int threadCount(const RunRequest& run) {
  constexpr int kMegabytesEach = 8;
  const int wanted = run.threads > 0 ? run.threads : std::min(hardwareThreads(), kMaxThreads);
  if (run.memoryLimit == 0) return wanted;
  return std::min(wanted, std::max(1, run.memoryLimit / kMegabytesEach));
}

/// Takes what a course may not know, checks what has to fit the picture's size, and finds the area
/// that is rendered.
void fitPicture(Draft& draft) {
  PictureRequest& picture = draft.render.picture;
  takeIdle(draft);
  takeJitter(draft);
  if (picture.acceleration.cellPicture != Acceleration::CellPicture::none) {
    picture.render.shadows &= picture.course->cells.haveShadows;
  }
  checkZooms(draft.render);
  checkPixel(draft.render);
  picture.isPart = draft.region || draft.band;
  if (picture.isPart) checkPart(draft);
  picture.area = draft.region ? draft.region(picture)
                 : draft.band ? draft.band(picture)
                              : PixelRectangle{0, 0, picture.width, picture.height};
}

}  // namespace

Request parseRequest(const std::vector<std::string>& commandLine, const RunRequest& defaults) {
  Draft draft;
  draft.run = defaults;
  const std::vector<std::string> words = separated(commandLine);
  if (words.empty()) draft.text = ProgramText::shortHelp;
  startFrom(courseOf(words), draft);
  readArguments(words, draft);
  draft.run.threads = threadCount(draft.run);
  if (draft.text != ProgramText::none) return draft;
  checkMode(draft);
  if (draft.compare.isWanted() || draft.merge.isWanted()) return draft;
  checkComplete(draft);
  const PictureRequest& picture = draft.render.picture;
  if (picture.course->withBounces && picture.render.maxBounces > 0) {
    draft.render = adapted(draft.render, *picture.course->withBounces, {});
  } else {
    fitPicture(draft);
  }
  return draft;
}

RenderRequest adapted(const RenderRequest& request, const Course& course,
                      const SceneParser::PictureSize& size) {
  Draft draft;
  if (size.width > 0) draft.render.picture.width = size.width;
  if (size.height > 0) draft.render.picture.height = size.height;
  startFrom(course, draft);
  for (const GivenArgument& given : request.given) {
    const ArgumentRow& row = *findArgument(given.name);
    row.action->apply(ArgumentWords(row, given.words), draft);
  }
  draft.render.picture.scene = request.picture.scene;  // a table's lies beside it, wherever it is
  draft.render.given = request.given;
  fitPicture(draft);
  return draft.render;
}
