// Blocks that begin with the count of what they hold, checks of values, and warnings.
#include "scene/scene_builder.h"
#include "scene/scene_words.h"

void SceneBuilder::readCounted(const CountedBlock& block, const std::function<void()>& readItem,
                               const std::function<bool()>& readOther) {
  if (!in_.openBlock(block.owner)) return;
  int count = 0;
  const bool isSure = readCount(block, count);
  readCountedItems(block, count, isSure, readItem, readOther);
}

/// Reads the count at the block's start. False where there is none to rely on.
bool SceneBuilder::readCount(const CountedBlock& block, int& count) {
  if (!isWord(in_.word(), block.countName)) {
    in_.reportExpected(std::string(block.countName) + " at the start of " +
                       std::string(block.owner));
    return false;
  }
  in_.advance();
  const char* const at = in_.at();
  if (!in_.readWholeNumber(block.countName, count)) return false;
  if (count >= 0) return true;
  in_.report(at, "expected a count of at least 0 for " + std::string(block.countName) + ", found " +
                     in_.quotedAt(at));
  return false;
}

/// The count is only compared with, so that a huge one costs nothing.
void SceneBuilder::readCountedItems(const CountedBlock& block, int expected, bool isSure,
                                    const std::function<void()>& readItem,
                                    const std::function<bool()>& readOther) {
  const auto says = [&] {
    return std::string(block.countName) + " says " + std::to_string(expected) + ", but ";
  };
  int found = 0;
  while (in_.word() != "}") {
    if (block.items.contains(in_.word())) {
      if (isSure && found == expected) {
        in_.report(in_.at(), says() + std::string(block.owner) + " goes on: expected '}', found " +
                                 in_.quotedAt(in_.at()));
        isSure = false;
      }
      readItem();
      ++found;
    } else if (in_.atEnd() || WordList(kSectionWords).contains(in_.word())) {
      return in_.closeBlock(block.owner);
    } else if (!readOther()) {
      found += in_.skipUnknown(block.owner, block.allowed);
    }
  }
  if (isSure && found < expected) {
    in_.report(in_.at(), says() + std::string(block.owner) + " ends after " +
                             std::to_string(found) + ": expected " +
                             std::to_string(expected - found) + " more, found '}'");
  }
  in_.advance();
}

bool SceneBuilder::checkAbove(double bound, double value, const Field& field) {
  if (!field.at || value > bound) return true;
  in_.report(field.at, "expected " + std::string(field.name) + " above " +
                           std::to_string(int(bound)) + ", found " + in_.quotedAt(field.at));
  return false;
}

bool SceneBuilder::checkAtLeast(double bound, double value, const Field& field) {
  if (!field.at || value >= bound) return true;
  in_.report(field.at, "expected " + std::string(field.name) + " of at least " +
                           std::to_string(int(bound)) + ", found " + in_.quotedAt(field.at));
  return false;
}

bool SceneBuilder::checkNotZero(const Vec3d& vector, const Field& field) {
  if (!field.at || vector != Vec3d()) return true;
  in_.report(field.at, "expected a " + std::string(field.name) + " that is not zero, found 0 0 0");
  return false;
}

/// A colour with components from 0 to 1.
bool SceneBuilder::checkReflectance(const Vec3f& color, const Field& field) {
  if (!field.at) return true;
  Tokenizer words(in_.text().bytes().substr(in_.placeOf(field.at)));
  for (int axis = 0; axis < 3; ++axis) {
    const char* const at = words.next().data();
    if (color[axis] >= 0 && color[axis] <= 1) continue;
    in_.report(at, "expected " + std::string(field.name) +
                       " from 0 to 1 in each component, found " + in_.quotedAt(at));
    return false;
  }
  return true;
}

void SceneBuilder::warn(const char* at, const std::string& message) {
  const SourceText& text = in_.text();
  warnings_.emplace_back(in_.placeOf(at),
                         text.name() + ":" + std::to_string(text.lineAt(at)) + ": " + message);
}
