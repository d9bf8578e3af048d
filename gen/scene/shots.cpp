#include "scene/shots.h"

#include <algorithm>
#include <cmath>

namespace wold::scene {
namespace {

/// Of the shot that a frame belongs to, or of the last one.
std::size_t number_of_shot(const Scene& scene, int frame) {
  std::size_t shot = 0;
  for (int last = 0; shot + 1 < scene.shots.size(); ++shot) {
    last += frame_count(scene, scene.shots[shot]);
    if (frame <= last) break;
  }
  return shot;
}

double way(const Take& take, int frame) {
  return take.count < 2 ? 0.0 : (frame - take.first) / (take.count - 1.0);
}

double degree_on_the_way(const Shot& shot, double way) {
  if (shot.weathering.empty()) return 0.0;
  return std::lerp(shot.weathering.front(), shot.weathering.back(), way);
}

}  // namespace

int frame_count(const Scene& scene, const Shot& shot) {
  return std::max(1, static_cast<int>(std::lround(shot.seconds * scene.film.frames_per_second)));
}

int frame_count(const Scene& scene) {
  if (scene.shots.empty()) return static_cast<int>(scene.ageing.frames.size());
  return takes_of(scene).back().last();
}

std::vector<Take> takes_of(const Scene& scene) {
  if (scene.shots.empty()) return {whole_film(scene)};
  std::vector<Take> takes;
  int first = 1;
  for (const Shot& shot : scene.shots) {
    takes.push_back({first, frame_count(scene, shot)});
    first += takes.back().count;
  }
  return takes;
}

Take whole_film(const Scene& scene) { return {1, frame_count(scene)}; }

Take take_of(const Scene& scene, int frame) {
  return takes_of(scene)[number_of_shot(scene, frame)];
}

const Shot* shot_of(const Scene& scene, int frame) {
  return scene.shots.empty() ? nullptr : &scene.shots[number_of_shot(scene, frame)];
}

const Camera& camera_of(const Scene& scene, int frame) {
  const Shot* shot = shot_of(scene, frame);
  return shot != nullptr ? shot->camera : scene.camera;
}

std::vector<Camera> cameras_of(const Scene& scene) {
  if (scene.shots.empty()) return {scene.camera};
  std::vector<Camera> cameras;
  for (const Shot& shot : scene.shots) cameras.push_back(shot.camera);
  return cameras;
}

double way_of_frame(const Scene& scene, int frame) { return way(take_of(scene, frame), frame); }

std::vector<double> weathering_of_shots(const Scene& scene) {
  const std::vector<Take> takes = takes_of(scene);
  std::vector<double> degrees;
  for (std::size_t shot = 0; shot < scene.shots.size(); ++shot)
    for (int frame = takes[shot].first; frame <= takes[shot].last(); ++frame)
      degrees.push_back(degree_on_the_way(scene.shots[shot], way(takes[shot], frame)));
  return degrees;
}

void take_frames_of_shots(Scene& scene) {
  if (scene.shots.empty()) return;
  scene.season.frames = frame_count(scene);
  scene.ageing.frames = weathering_of_shots(scene);
}

}  // namespace wold::scene
