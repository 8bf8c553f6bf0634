// Which line a place in the input stands on, and the input as a whole.
#include "scene/source_text.h"

#include <algorithm>

#include "scene/input_error.h"
#include "scene/whole_file.h"

SourceText SourceText::read(const std::string& filename) {
  std::string bytes, reason;
  const bool isStandardInput = filename == "-";
  const std::string name = isStandardInput ? "<stdin>" : filename;
  const bool isRead =
      isStandardInput ? readStandardInput(bytes, reason) : readWholeFile(filename, bytes, reason);
  if (!isRead) throw InputError(name, 0, "cannot be read: " + reason);
  return SourceText(name, std::move(bytes));
}

std::size_t SourceText::lineAt(const char* place) const {
  return 1 + std::size_t(std::count(bytes_.data(), place, '\n'));
}
