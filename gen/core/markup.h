#pragma once

#include <string>
#include <string_view>

namespace wold {

/// Text as it stands in XML and HTML, between tags or in a quoted attribute.
std::string markup_escaped(std::string_view text);

/// A template with every `mark` replaced by `text`.
std::string filled(std::string page, std::string_view mark, std::string_view text);

}  // namespace wold
