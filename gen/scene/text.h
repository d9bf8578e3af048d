#pragma once

#include <string>
#include <string_view>

namespace wold::scene {

/// The user's text for a message: in quotes, control characters as "?", shortened to 40 bytes at
/// a character's boundary. Safe to print on a terminal whatever the file held.
std::string in_quotes(std::string_view text);

/// The same without quotes, for keys.
std::string shown(std::string_view text);

/// The shortest text that reads back as the same number, always with a point or an exponent.
std::string number_text(double value);

/// The name of an item, from 0, of an array of tables, "clouds[1]": people count from 1.
std::string item_name(std::string_view array, std::size_t item);

}  // namespace wold::scene
