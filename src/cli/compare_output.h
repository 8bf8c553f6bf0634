// What a comparison gives out: text, rows of a table, a page.
#pragma once
#include <string>
#include <vector>

#include "cli/compared_pair.h"

/// All figures of one pair, in lines `name: value`.
std::string figureLines(const ComparedPair& pair, const CompareRequest& options);

/// One line for each pair and one that counts them.
std::string pairLines(const std::vector<ComparedPair>& pairs);

/// "same, 3 pixels over" and so on: a pair's verdict in a few words.
std::string verdict(const ComparedPair& pair);

/// A number as all of these print it: 6 significant digits, `inf` for infinity.
std::string numberText(double value);

/// The heading of the table of comma-separated values, and a pair's row (RFC 4180), each with its
/// end. Fields that a pair has no value for are empty.
std::string csvHeading();
std::string csvRow(const ComparedPair& pair);

/// The page: one file that needs nothing from outside. Pairs come as they are given. Names may hold
/// any bytes.
std::string reportPage(const std::vector<ComparedPair>& pairs, const CompareRequest& options);
