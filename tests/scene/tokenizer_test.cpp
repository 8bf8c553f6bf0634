// Words of a scene file.
#include <string>

#include "check.h"
#include "random.h"
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
  CHECK_EQUAL(::quoted("foo"), "'foo'");
  CHECK_EQUAL(::quoted(std::string_view("a\0\n\xff", 4)), "'a\\x00\\x0a\\xff'");
  CHECK_EQUAL(::quoted(std::string(1'000'000, 'x')), "'" + std::string(40, 'x') + "...'");
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

TEST("random bytes are cut into the words that one byte after the other gives") {
  // Blanks in rows and words of all lengths.
  const std::string letters = "   \n\t\r\v\f{}#//ab-.0129|~z!\x7f\x01\x1f\x80\xff";
  Random random(41);
  std::size_t found = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (int size = random.index(60); size > 0; --size) {
      const char letter = letters[std::size_t(random.index(int(letters.size())))];
      text.append(std::size_t(random.index(4) == 0 ? random.index(20) : 1), letter);
    }
    std::string expected;
    bool isInWord = false, isInComment = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
      const char c = text[at];
      const bool isSpace = c == ' ' || (c >= '\t' && c <= '\r'), isBrace = c == '{' || c == '}';
      isInComment = isInComment && c != '\n';
      if (isInComment) continue;
      isInComment = !isInWord && (c == '#' || text.compare(at, 2, "//") == 0);
      if (isInComment) continue;
      if (!isSpace && (isBrace || !isInWord) && !expected.empty()) expected += '|';
      if (!isSpace) expected += c;
      isInWord = !isSpace && !isBrace;
    }
    const std::string cut = words(text);
    if (cut != expected) check::report(false, __FILE__, __LINE__, text + ": " + cut);
    found += cut.size();
  }
  CHECK(found > 50'000);
}
