// Reading the words that follow an argument. Each function throws UsageError, naming the argument,
// what was expected and what was found.
#pragma once
#include <string>

#include "cli/option_table.h"
#include "scene/wording.h"

/// The first word is none of the `choices`: says so, and which one was probably meant.
[[noreturn]] void failChoice(const GivenOption& given, WordList choices);

/// A whole number from `least` to `most`, in word `index`; `what` names it in the message.
int wholeNumber(const GivenOption& given, std::size_t index, const char* what, int least, int most);

/// A finite number of at least 0 in the first word, which may also be one of the words that
/// `alternatives` names for the message, e.g. ", 'course' or 'adaptive'".
double positiveNumber(const GivenOption& given, const char* alternatives);

/// As positiveNumber, rounded once to float; beyond the range of float is a mistake.
float positiveFloat(const GivenOption& given);

/// A number from `least` to `most` in word `index`; `expected` says so in the message.
double numberInRange(const GivenOption& given, std::size_t index, double least, double most,
                     const std::string& expected);

/// A file name in the first word: anything but "". "-" is standard input or output; for what must
/// be a plain file it is a mistake.
std::string inputName(const GivenOption& given);
std::string outputName(const GivenOption& given);
std::string plainFileName(const GivenOption& given);

/// MIN MAX FILE, or FILE MIN MAX where the first word is no number; MIN and MAX must differ.
void readDepth(const GivenOption& given, Options& options);
