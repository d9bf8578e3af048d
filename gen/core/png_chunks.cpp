#include "core/png_chunks.h"

#include <cstddef>

#include "core/error.h"

namespace wold {
namespace {

constexpr std::size_t signature_length = 8;
constexpr std::size_t around_data = 4 + 4 + 4;  // length, type and checksum of a chunk

std::size_t big_endian(const std::string& bytes, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// By the case of the first letter of its type (ISO/IEC 15948, 5.4).
bool is_ancillary(char first_letter) {
  return (static_cast<unsigned char>(first_letter) & 32U) != 0;
}

}  // namespace

std::string without_ancillary_chunks(const std::string& png) {
  if (png.compare(0, signature_length, "\x89PNG\r\n\x1a\n") != 0)
    throw FileError("it is no PNG file");
  std::string kept = png.substr(0, signature_length);
  for (std::size_t at = signature_length; at < png.size();) {
    if (png.size() - at < around_data) throw FileError("a chunk of PNG ends too early");
    const std::size_t length = around_data + big_endian(png, at);
    if (png.size() - at < length) throw FileError("a chunk of PNG ends too early");
    if (!is_ancillary(png[at + 4])) kept.append(png, at, length);
    at += length;
  }
  return kept;
}

}  // namespace wold
