#pragma once

#include "core/expected_picture.h"
#include "landscape/landscape.h"

namespace wold::expectation {

/// What the landscape's picture should show, with and without each kind of thing that a renderer
/// could leave out: "grass" (volumes), "blades" (meshes of blades or points) and "clouds"
/// (volumes).
///
/// It is an estimate by a few rays in each of at most 32 x 18 tiles. A ray goes on to the ground
/// through the cells before it, each of which looks as a whole meadow of what it has would; grass
/// on a nearer crest, before the sky or farther ground, is left out. Volumes are read from their
/// files, but few and coarse ones have to speak for all, so that the estimate takes no more than a
/// few tenths of a second. Flakes dim the tiles and are no kind: they cover too little of most
/// pictures. Throws FileError.
ExpectedPicture expected_picture(const landscape::Landscape& landscape);

}  // namespace wold::expectation
