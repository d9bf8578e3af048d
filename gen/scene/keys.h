#pragma once

#include <vector>

#include "scene/registry.h"

namespace wold::scene {

/// The registry's entries, one function per table of the scene file.
std::vector<Key> top_level_keys();
std::vector<Key> terrain_keys();
std::vector<Key> growth_keys();
std::vector<Key> grass_keys();
std::vector<Key> ageing_keys();
std::vector<Key> fur_keys();
std::vector<Key> sun_keys();
std::vector<Key> sky_keys();
std::vector<Key> wind_keys();
std::vector<Key> film_keys();
std::vector<Key> weather_keys();
std::vector<Key> season_keys();
std::vector<Key> snowfall_keys();
std::vector<Key> rainfall_keys();
std::vector<Key> snow_cover_keys();
std::vector<Key> camera_keys();
std::vector<Key> render_keys();

/// Those of an item, from 0, of a table that may stand many times.
std::vector<Key> cloud_keys(std::size_t item);
std::vector<Key> cloud_event_keys(std::size_t item);
std::vector<Key> season_key_keys(std::size_t item);
std::vector<Key> shot_keys(std::size_t item);
std::vector<Key> species_keys(std::size_t item);
std::vector<Key> path_keys(std::size_t item);
std::vector<Key> cover_class_keys(std::size_t item);

/// More layers no picture shows, and each costs its map.
inline constexpr std::size_t max_cloud_layers = 16;
inline constexpr std::size_t max_cloud_events = 1000;
inline constexpr std::size_t max_season_keys = 1000;
inline constexpr std::size_t max_shots = 200;
inline constexpr int max_film_frames = 10000;
inline constexpr std::size_t max_paths = 16;
inline constexpr std::size_t max_cover_classes = 256;
/// Each is simulated by itself.
inline constexpr std::size_t max_species = 16;

}  // namespace wold::scene
