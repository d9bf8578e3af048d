#include "film/film_demand.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "meadow/cells.h"
#include "meadow/far_field.h"
#include "place/mixture_field.h"
#include "place/view.h"
#include "place/withering.h"
#include "scene/shots.h"
#include "scene/winter.h"
#include "snow/cover.h"

namespace wold::film {
namespace {

constexpr std::size_t max_sampled = 8;

/// All of them, or some from the first to the last: `max`, at least 2.
std::vector<int> spread(const std::vector<int>& frames, std::size_t max) {
  if (frames.size() <= max) return frames;
  std::vector<int> chosen;
  for (std::size_t i = 0; i < max; ++i)
    chosen.push_back(frames[i * (frames.size() - 1) / (max - 1)]);
  return chosen;
}

/// Those of each take that has some.
std::vector<std::vector<int>> by_take(const scene::Scene& scene, const std::vector<int>& frames) {
  std::vector<std::vector<int>> takes;
  for (const scene::Take& take : scene::takes_of(scene)) {
    std::vector<int> of_take;
    for (const int frame : frames)
      if (frame >= take.first && frame <= take.last()) of_take.push_back(frame);
    if (!of_take.empty()) takes.push_back(std::move(of_take));
  }
  return takes;
}

/// The parts of a Site that cells are chosen from.
class Ground {
 public:
  Ground(const scene::Scene& scene, const place::GrowingGround& land,
         std::shared_ptr<const phenology::FilmSeason> season)
      : scene_(scene),
        terrain_(land.ground.heights_m),
        growth_(land.growth_of_cells),
        mixtures_(scene, terrain_),
        withering_(scene, terrain_, season),
        weather_(scene, season.get()),
        season_(std::move(season)) {
    constexpr int enough_samples = 17;  // only when snow falls is asked
    if (scene::may_lie(scene))
      snow_.emplace(
          scene, terrain_, [this](double time_s) { return weather_.at(time_s); }, enough_samples);
  }
  Ground(const Ground&) = delete;  // the snow asks its weather
  Ground& operator=(const Ground&) = delete;

  const std::vector<int>& mixtures() const { return mixtures_.present(); }

  FrameDemand demand(int frame) const {
    FrameDemand demand;
    const meadow::FrameGrass now = meadow::still_grass(scene_, season_.get(), weather_, frame);
    const std::vector<meadow::CellChoice> cells =
        meadow::choose_cells(scene_, terrain_, growth_, mixtures_, withering_, now);
    if (!cells.empty()) demand.across_m = meadow::square_of_cells(scene_, cells).size_m;
    for (const meadow::CellChoice& cell : cells) {
      demand.parts += cell.parts.size();
      if (cell.blades)
        demand.patches.insert({cell.variant, cell.state()});
      else
        demand.volumes.insert({cell.variant, cell.state(), cell.lod, cell.turn});
    }
    demand.has_distance = has_distance(frame);
    demand.has_snow = snow_ && snow_->at(scene::time_s(scene_, frame)).fallen_mm > 0.0;
    return demand;
  }

 private:
  bool has_distance(int frame) const {
    const landscape::Camera camera = place::camera_of_frame(scene_, terrain_, frame);
    return meadow::has_far_field(
        scene_, terrain_, place::View(camera, scene_.render.size_px[0], scene_.render.size_px[1]));
  }

  const scene::Scene& scene_;
  const Heightfield& terrain_;
  const FactorMap& growth_;
  place::MixtureField mixtures_;
  place::Withering withering_;
  snow::Weather weather_;
  std::shared_ptr<const phenology::FilmSeason> season_;
  std::optional<snow::SnowGround> snow_;
};

/// The states on the straight way from one to another, without the first.
std::vector<grass::PatchState> states_between(const grass::PatchState& from,
                                              const grass::PatchState& to) {
  const int steps = std::max({std::abs(to.key_frame - from.key_frame),
                              std::abs(to.snow - from.snow), std::abs(to.light - from.light)});
  const auto at = [&](int a, int b, int step) { return a + (b - a) * step / steps; };
  std::vector<grass::PatchState> states;
  for (int step = 1; step <= steps; ++step)
    states.emplace_back(at(from.key_frame, to.key_frame, step), at(from.snow, to.snow, step),
                        at(from.light, to.light, step));
  return states;
}

}  // namespace

FilmDemand::FilmDemand(const Request& request, const place::GrowingGround& land) {
  const Ground ground(request.scene, land, request.season);
  mixtures_ = ground.mixtures();
  const std::vector<std::vector<int>> takes = by_take(request.scene, request.frames);
  for (const std::vector<int>& take : takes) {
    const std::size_t max = std::max<std::size_t>(2, max_sampled / takes.size());
    const FrameDemand* last = nullptr;
    for (const int frame : spread(take, max)) {
      const FrameDemand& now = frames_.emplace(frame, ground.demand(frame)).first->second;
      volumes_.insert(now.volumes.begin(), now.volumes.end());
      patches_.insert(now.patches.begin(), now.patches.end());
      if (last && take.size() > max) pass(*last, now);
      last = &now;
    }
  }
}

/// Adds what frames between two show: every variant goes from its last state to its next.
void FilmDemand::pass(const FrameDemand& from, const FrameDemand& to) {
  std::map<std::tuple<int, int, int>, grass::PatchState> then;
  for (const ShownVolume& volume : from.volumes)
    then.insert_or_assign({volume.variant, volume.lod, volume.turn}, volume.state);
  for (const ShownVolume& volume : to.volumes)
    if (const auto before = then.find({volume.variant, volume.lod, volume.turn});
        before != then.end())
      for (const grass::PatchState& state : states_between(before->second, volume.state))
        volumes_.insert({volume.variant, state, volume.lod, volume.turn});
}

const FrameDemand& FilmDemand::at(int frame) const {
  const auto after = frames_.lower_bound(frame);
  if (after == frames_.end()) return std::prev(after)->second;
  if (after == frames_.begin() || after->first == frame) return after->second;
  const auto before = std::prev(after);
  return frame - before->first < after->first - frame ? before->second : after->second;
}

}  // namespace wold::film
