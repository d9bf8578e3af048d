#pragma once

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <memory>

namespace wold {

/// Opens a picture of a kind that read_image() knows, after its size has been checked. For readers
/// in this room alone: OpenImageIO stays behind them. Throws as read_image() does.
std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path);

}  // namespace wold
