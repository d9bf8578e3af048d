#pragma once

#include "landscape/landscape.h"
#include "place/site.h"

namespace wold::ground {

/// The boulders that a landscape's camera may see, as triangles on its terrain: as many as each of
/// them needs in the picture. None that is so far away that the ground's pictures show it well
/// enough, that lies under snow or that the eye would stand in. The landscape has its terrain,
/// camera and size; the site has to have boulders.
landscape::RaisedGround boulders_in_view(const place::Site& site,
                                         const landscape::Landscape& landscape);

}  // namespace wold::ground
