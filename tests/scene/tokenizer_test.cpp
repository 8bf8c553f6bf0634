// Words of a scene file.
#include "scene/tokenizer.h"

#include <string>

#include "check.h"
#include "scene/source_text.h"
#include "scene/wording.h"

namespace {

/// The words of `text` with a | between them.
std::string words(std::string_view text) {
  Tokenizer tokenizer(text);
  std::string joined;
  for (std::string_view word = tokenizer.next(); !word.empty(); word = tokenizer.next()) {
    joined += (joined.empty() ? "" : "|") + std::string(word);
  }
  CHECK(tokenizer.next().empty());
  return joined;
}

}  // namespace

TEST("white space separates words and braces are words of their own") {
  CHECK_EQUAL(words("a b\tc\r\nd\n\n e\v\ff"), "a|b|c|d|e|f");
  CHECK_EQUAL(words("Group{numObjects 1}}{x{y"), "Group|{|numObjects|1|}|}|{|x|{|y");
  CHECK_EQUAL(words(""), "");
  CHECK_EQUAL(words(" \n "), "");
}

TEST("a comment begins only where a word would begin") {
  CHECK_EQUAL(words("a # b c\nd // e\r\nf"), "a|d|f");
  CHECK_EQUAL(words("a#b c//d /x"), "a#b|c//d|/x");
  CHECK_EQUAL(words("}# x\n{// y\n1"), "}|{|1");
  CHECK_EQUAL(words("a #"), "a");
  CHECK_EQUAL(words("a //"), "a");
  CHECK_EQUAL(words("a /"), "a|/");
}

TEST("a byte-order mark is passed over at the start only") {
  CHECK_EQUAL(words("\xEF\xBB\xBF"
                    "a b"),
              "a|b");
  CHECK_EQUAL(words("a \xEF\xBB\xBF"
                    "b"),
              "a|\xEF\xBB\xBF"
              "b");
  CHECK_EQUAL(words("\xEF\xBB"), "\xEF\xBB");
}

TEST("bytes beyond ASCII and zeros are parts of words") {
  CHECK_EQUAL(words(std::string_view("a\0b \xff", 5)), std::string("a\0b|\xff", 5));
}

TEST("lines are counted by their newlines") {
  const SourceText text("name", "a\r\nb\n\nc");
  const char* const start = text.bytes().data();
  CHECK_EQUAL(text.lineAt(start), 1u);
  CHECK_EQUAL(text.lineAt(start + 3), 2u);
  CHECK_EQUAL(text.lineAt(start + 6), 4u);
}

TEST("words are quoted short and printable") {
  CHECK_EQUAL(quoted("foo"), "'foo'");
  CHECK_EQUAL(quoted(std::string_view("a\0\n\xff", 4)), "'a\\x00\\x0a\\xff'");
  CHECK_EQUAL(quoted(std::string(1'000'000, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST("the nearest word is found for a slip and none for another word") {
  constexpr std::string_view kAllowed[] = {"Sphere", "Plane", "TriangleMesh", "Triangle"};
  CHECK_EQUAL(nearestWord("Sphear", kAllowed), "Sphere");
  CHECK_EQUAL(nearestWord("SPHERE", kAllowed), "Sphere");
  CHECK_EQUAL(nearestWord("Trangle", kAllowed), "Triangle");
  CHECK_EQUAL(nearestWord("TriangelMesh", kAllowed), "TriangleMesh");
  CHECK_EQUAL(nearestWord("Cube", kAllowed), "");
  // Two letters swapped are one slip: of five letters no more may be wrong.
  CHECK_EQUAL(nearestWord("Plnae", kAllowed), "Plane");
  CHECK_EQUAL(nearestWord("lPane", kAllowed), "Plane");
  CHECK_EQUAL(nearestWord(std::string(1'000'000, 'S'), kAllowed), "");
  CHECK_EQUAL(listed(kAllowed), "Sphere, Plane, TriangleMesh or Triangle");
}
