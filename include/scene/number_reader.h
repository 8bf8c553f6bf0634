// Reading numbers from words: correctly rounded, and the same in every locale.
// A number is [+-] digits [. digits] [e|E [+-] digits] with at least one digit before the
// exponent: 5. and .5 and +5 and 1e3 are numbers; nan, inf, 0x5, 5x and 1e are not.
#pragma once
#include <string_view>

/// True when `word`, as a whole, is written as a number, be it ever so large or small.
bool isNumber(std::string_view word);

/// For T float or double: stores in `value` the T nearest to the number that `word` is, ties to
/// even (rounded once, straight from the decimal digits), and returns true. Too small a number
/// gives a denormal or a zero of its sign. Returns false and leaves `value` as it was where `word`
/// is no number, or one too large for the type.
template <class T>
bool readNumber(std::string_view word, T& value);

/// Reads the longest number that begins at `p`, stores it like readNumber, and returns where it
/// ends, which is the whole word if that is the word's end. Returns null, and leaves `value` as it
/// was, where no number begins, its exponent has no digits, or it is too large.
template <class T>
const char* scanNumber(const char* p, const char* end, T& value);

/// Stores the whole number that `word` is ([+-] digits) and returns true. Returns false and leaves
/// `value` as it was for anything else (5.0, 1e3), and where it does not fit in an int.
bool readInt(std::string_view word, int& value);
