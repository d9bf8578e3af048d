#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/keys.h"

/// A key's field in an item of a list of the scene, for reading and writing alike.
#define ITEM_FIELD(list, path) ([item](auto& scene) -> auto& { return scene.list[item].path; })

namespace wold::scene {

std::vector<Key> cloud_keys(std::size_t item) {
  return {
      bound(word("clouds.kind", "A veil, rolls and patches, heaps, or fibres."),
            ITEM_FIELD(clouds, kind)),
      bound(list(Kind::files, "clouds.textures", "", {0, 0}, {.min_items = 0, .max_items = 16},
                 "Pictures of clouds, whose alpha or else luminance is the opacity; without any, "
                 "textures are made for the kind. Relative paths start at the scene file."),
            ITEM_FIELD(clouds, textures)),
      bound(automatic("clouds.base", "m", {10, 20000},
                      "Height of the base above the terrain's zero; \"auto\" here and below is "
                      "what is usual for the kind."),
            ITEM_FIELD(clouds, base_m)),
      bound(automatic("clouds.thickness", "m", {1, 10000}, "From base to top of the thickest."),
            ITEM_FIELD(clouds, thickness_m)),
      bound(automatic("clouds.cell", "m", {10, 100000},
                      "Side of the square that one texture covers; the layer's scale. \"auto\" is "
                      "wider for cumulus that is thicker than usual, up to ten times."),
            ITEM_FIELD(clouds, cell_m)),
      bound(list(Kind::integers, "clouds.cells", "", {1, 64}, {.min_items = 2, .max_items = 2},
                 "Cells to the east and to the north after which the layer repeats; the paper's m "
                 "and n."),
            ITEM_FIELD(clouds, cells)),
      bound(automatic("clouds.cover", "", {0, 1},
                      "Share of the sky that is covered, of own pictures the share of their "
                      "clouds; \"auto\" leaves them as they are."),
            ITEM_FIELD(clouds, cover)),
      bound(automatic("clouds.opacity", "", {0, 0.995}, "Of the densest place, seen from below."),
            ITEM_FIELD(clouds, opacity)),
      bound(number("clouds.gathered", "", {0, 1},
                   "How much of the layer is there when the film starts: 0 is a clear sky."),
            ITEM_FIELD(clouds, gathered)),
      bound(word("clouds.repeat",
                 "How textures fill the layer: blended without seam or visible repetition, or one "
                 "in each cell as the paper has it, seams and all."),
            ITEM_FIELD(clouds, repeat)),
      bound(word("clouds.motion",
                 "Drift by speed, heading and gusts, or the paper's x += 0.0001 and y = sin x "
                 "cells a frame."),
            ITEM_FIELD(clouds, motion)),
      bound(number("clouds.speed", "m/s", {0, 100},
                   "Speed of the drift; in a season when the wind is as [wind] says."),
            ITEM_FIELD(clouds, speed_m_s)),
      bound(number("clouds.heading", "deg", {0, 360},
                   "Where the clouds drift to, clockwise from north; a west wind has 90."),
            ITEM_FIELD(clouds, heading_deg)),
      bound(number("clouds.gusts", "m/s", {0, 30},
                   "Standard deviation of the drift's velocity, along each axis."),
            ITEM_FIELD(clouds, gusts_m_s)),
      bound(
          word("clouds.light", "Bases darken with thickness, or clouds are white as in the paper."),
          ITEM_FIELD(clouds, light)),
      bound(word("clouds.body", "A textured, curved sheet, which is fast, or a volume."),
            ITEM_FIELD(clouds, body)),
  };
}

std::vector<Key> cloud_event_keys(std::size_t item) {
  return {
      bound(word("cloud_events.kind",
                 "The wind turns and shears the clouds, drift grows or falls, clouds gather or "
                 "dissipate, or their light changes colour."),
            ITEM_FIELD(cloud_events, kind)),
      bound(integer("cloud_events.layer", "", {0, static_cast<double>(max_cloud_layers)},
                    "To which [[clouds]] it happens, counted from 1; 0 is all."),
            ITEM_FIELD(cloud_events, layer)),
      bound(number("cloud_events.start", "s", {0, 1e9}, "When it begins, since the first frame."),
            ITEM_FIELD(cloud_events, start_s)),
      bound(number("cloud_events.duration", "s", {0.001, 1e9}, "How long it takes."),
            ITEM_FIELD(cloud_events, duration_s)),
      bound(
          list(Kind::integers, "cloud_events.date", "", {1, 2999}, {.min_items = 0, .max_items = 3},
               "In a season: year, month and day on which it begins, instead of start."),
          ITEM_FIELD(cloud_events, date)),
      bound(list(Kind::integers, "cloud_events.until", "", {1, 2999},
                 {.min_items = 0, .max_items = 3},
                 "In a season, with date: the day on which it has happened, instead of duration."),
            ITEM_FIELD(cloud_events, until)),
      bound(number("cloud_events.heading", "deg", {0, 360},
                   "Wind: where the clouds drift to afterwards, clockwise from north; the drift "
                   "turns the shorter way."),
            ITEM_FIELD(cloud_events, heading_deg)),
      bound(number("cloud_events.speed", "m/s", {0, 100}, "Wind: speed of the drift afterwards."),
            ITEM_FIELD(cloud_events, speed_m_s)),
      bound(number("cloud_events.shear", "", {0, 1},
                   "Wind: how far it draws out the clouds; 0 keeps their shape."),
            ITEM_FIELD(cloud_events, shear)),
      bound(number("cloud_events.factor", "", {1, 100},
                   "Faster: of the speed afterwards; slower: its inverse."),
            ITEM_FIELD(cloud_events, factor)),
      bound(number("cloud_events.fraction", "", {0, 1},
                   "Gather, dissipate: how much of the way to the whole layer, or to a clear sky."),
            ITEM_FIELD(cloud_events, fraction)),
      bound(list(Kind::numbers, "cloud_events.colour", "", {0, 1}, {.min_items = 0, .max_items = 3},
                 "Light: its colour afterwards, linear red, green and blue, where [1, 1, 1] is a "
                 "clear day; an empty list takes it from sun_elevation."),
            ITEM_FIELD(cloud_events, colour)),
      bound(number("cloud_events.sun_elevation", "deg", {1, 90},
                   "Light, without a colour: sunlight's when the sun stands so high."),
            ITEM_FIELD(cloud_events, sun_elevation_deg)),
      bound(word("cloud_events.fade",
                 "Wind, gather, dissipate: fades optical depths and cover, or alpha as the paper "
                 "does, whose clouds are thinner half-way through a wind."),
            ITEM_FIELD(cloud_events, fade)),
  };
}

}  // namespace wold::scene
