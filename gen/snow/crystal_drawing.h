#pragma once

#include <cstdint>

#include "core/image.h"
#include "snow/fall_speed.h"

/// Snow crystals drawn by what makes them: six-fold growth, side branches, hexagonal faces.
namespace wold::snow {

/// The opacity of a crystal of that kind, the same for the same key; see CrystalPicture.
Image drawn_crystal(Crystal crystal, int side_px, std::uint64_t key);

/// A soft round spot.
Image drawn_disc(int side_px);

/// What a soft spot leaves that moves up the picture.
Image drawn_streak(int side_px);

}  // namespace wold::snow
