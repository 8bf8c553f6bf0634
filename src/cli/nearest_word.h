// The word that was probably meant.
#pragma once
#include <string>
#include <vector>

/// The one of `words` that needs the fewest changes (insert, remove or replace a letter, swap two
/// neighbours) to become `word`, the first of several; "" where even that needs more than a third
/// of the longer word's letters, rounded up.
std::string nearestWord(const std::string& word, const std::vector<std::string>& words);
