#pragma once

#include <vector>

#include "scene/scene.h"

/// How the frames of a film follow each other. A scene with [[shots]] has those of the first, then
/// those of the second, and so on; any other film is one way from its first frame to its last.
namespace wold::scene {

/// Frames without a cut between them: those of a shot, or all of a film without shots.
struct Take {
  int first = 1;  ///< from 1
  int count = 1;  ///< at least 1

  int last() const { return first + count - 1; }
  bool operator==(const Take&) const = default;
};

/// How many frames a shot is played for: its seconds at film.frames_per_second, to the nearest, and
/// one at least.
int frame_count(const Scene& scene, const Shot& shot);

/// Of the film. Without shots as many as ageing.frames, which in a season phenology::as_film()
/// makes.
int frame_count(const Scene& scene);

/// The film's takes in their order: as many as shots, or one.
std::vector<Take> takes_of(const Scene& scene);

/// All of the film as if it had no cut.
Take whole_film(const Scene& scene);

/// That of a frame (from 1), or the last one where the film has no such frame.
Take take_of(const Scene& scene, int frame);

/// The shot of a frame (from 1); nullptr where the scene has none.
const Shot* shot_of(const Scene& scene, int frame);

/// Its camera, with the way that it goes from the take's first frame to its last.
const Camera& camera_of(const Scene& scene, int frame);

/// Those of all takes.
std::vector<Camera> cameras_of(const Scene& scene);

/// How far a frame (from 1) is on the way from its take's first to its last, in [0, 1].
double way_of_frame(const Scene& scene, int frame);

/// The weathering degrees of all frames as the shots say them; for a scene that is no season.
std::vector<double> weathering_of_shots(const Scene& scene);

/// Gives a scene of shots their frames as ageing.frames and season.frames, which others may not
/// say.
void take_frames_of_shots(Scene& scene);

}  // namespace wold::scene
