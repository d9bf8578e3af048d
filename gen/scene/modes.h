#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <type_traits>

/// The modes that a scene chooses among. The words that scene files have for a mode stand once,
/// beside its enum and in the order of its enumerators. Only the registry turns words into modes.
namespace wold::scene {

/// An enum with words: words_of(Enum) returns them, one for each enumerator.
template <class T>
concept Mode = std::is_enum_v<T> && requires(T mode) {
  words_of(mode);
};

/// The word of a mode, as scene files and messages have it.
template <Mode T>
constexpr std::string_view word_of(T mode) {
  return words_of(mode)[static_cast<std::size_t>(mode)];
}

/// terrain.shape: a slope with a crest, or ridges and valleys.
enum class TerrainShape { hillside, mountain };
constexpr auto words_of(TerrainShape) { return std::array{"hillside", "mountain"}; }

/// terrain.water: where lakes and rivers are, by what elevation model and land cover show of them,
/// or nowhere.
enum class WaterSource { automatic, none };
constexpr auto words_of(WaterSource) { return std::array{"auto", "none"}; }

/// ageing.colour: how pigments become colour. PROSPECT is a model of leaves, `paper` has the
/// functions of paper 1, and melanin colours hair.
enum class ColourModel { prospect, paper, melanin };
constexpr auto words_of(ColourModel) { return std::array{"prospect", "paper", "melanin"}; }

/// species.petal_colour: what pigments petals have (models/flower/petals.toml, in this order).
enum class PetalColour { white, yellow, pink, violet, blue, red };
constexpr auto words_of(PetalColour) {
  return std::array{"white", "yellow", "pink", "violet", "blue", "red"};
}

/// ageing.droop_rule: how a blade bows. `paper` turns it about its root, `elastica` bends it under
/// its own weight.
enum class DroopRule { paper, elastica };
constexpr auto words_of(DroopRule) { return std::array{"paper", "elastica"}; }

/// ageing.motion: how a blade gets to its shape, by the rule's closed form or point by point
/// (Algorithm 1 of paper 1).
enum class AgeingMotion { closed_form, points };
constexpr auto words_of(AgeingMotion) { return std::array{"closed_form", "points"}; }

/// wind.field: how the wind carries flakes, evenly, in gusts or round a tornado.
enum class WindPattern { steady, gusts, tornado };
constexpr auto words_of(WindPattern) { return std::array{"steady", "gusts", "tornado"}; }

/// wind.grass: whether grass stands as it has been combed, or waves in the wind of the moment.
enum class GrassMotion { still, waving };
constexpr auto words_of(GrassMotion) { return std::array{"still", "waving"}; }

/// render.grass: what grass is drawn as. `automatic` is blades where the finest texel is too coarse
/// and texels beyond.
enum class GrassForm { texels, blades, automatic, points };
constexpr auto words_of(GrassForm) { return std::array{"texels", "blades", "auto", "points"}; }

/// render.device: what Blender computes on. `automatic` is a graphics card if there is one.
enum class Device { cpu, gpu, automatic };
constexpr auto words_of(Device) { return std::array{"cpu", "gpu", "auto"}; }

/// snowfall.strength: the weather's precipitation, or a rate of its own.
enum class SnowfallStrength { weather, light, moderate, blizzard };
constexpr auto words_of(SnowfallStrength) {
  return std::array{"weather", "light", "moderate", "blizzard"};
}

/// snowfall.motion, clouds.motion and clouds.light: whether something follows physics or the
/// formulas of the paper.
enum class Law { physical, paper };
constexpr auto words_of(Law) { return std::array{"physical", "paper"}; }

/// snowfall.crystal: what near flakes look like. `mixed` is a fraction of each that depends on
/// size.
enum class CrystalChoice { mixed, dendrite, plate, column, aggregate };
constexpr auto words_of(CrystalChoice) {
  return std::array{"mixed", "dendrite", "plate", "column", "aggregate"};
}

/// snow_cover.cover: snow of a depth that follows the weather, the paper's whitening, or none.
enum class CoverModel { depth, paper, none };
constexpr auto words_of(CoverModel) { return std::array{"depth", "paper", "none"}; }

/// clouds.kind: a veil, rolls and patches, heaps or fibres. Its words are also the names of the
/// files of models/cloud.
enum class CloudKind { stratus, stratocumulus, cumulus, cirrus };
constexpr auto words_of(CloudKind) {
  return std::array{"stratus", "stratocumulus", "cumulus", "cirrus"};
}

/// clouds.repeat: how textures fill a layer, blended or one in each cell.
enum class CloudRepeat { blend, paper };
constexpr auto words_of(CloudRepeat) { return std::array{"blend", "paper"}; }

/// clouds.body: a textured, curved sheet, or a volume.
enum class CloudBody { sheet, volume };
constexpr auto words_of(CloudBody) { return std::array{"sheet", "volume"}; }

/// cloud_events.kind: what happens to the clouds. The first three change their drift, the next two
/// their amount.
enum class CloudEventKind { wind, faster, slower, gather, dissipate, light };
constexpr auto words_of(CloudEventKind) {
  return std::array{"wind", "faster", "slower", "gather", "dissipate", "light"};
}

/// cloud_events.fade: whether an event fades optical depths or, as in the paper, alpha.
enum class CloudFade { optical, paper };
constexpr auto words_of(CloudFade) { return std::array{"optical", "paper"}; }

}  // namespace wold::scene
