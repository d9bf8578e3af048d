#pragma once

#include <string>
#include <vector>

/// What is wrong with the text of an option: "found ..., expected ...", or "" where it is right.
namespace wold::cli {

/// Of one of some words.
std::string word_fault(const std::string& text, const std::vector<std::string>& words);

/// Of a whole number from `min` to `max`.
std::string whole_number_fault(const std::string& text, int min, int max);

/// Of a number from `min` to `max`, which may be infinite; CLI11's own check lets NaN pass.
std::string number_fault(const std::string& text, double min, double max);

/// Of a size in memory such as 8G: a whole number and a unit of 1024s, from 1M to 1e18 bytes. A
/// unit alone would be taken for one of it, and a number alone is mostly a unit forgotten.
std::string size_fault(const std::string& text);

}  // namespace wold::cli
