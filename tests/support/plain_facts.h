#pragma once

#include "passes/ground_facts.h"

namespace wold::test {

/// What a landscape of one species, without snow, weather or painted grass is told of.
inline passes::GroundFacts plain_facts(const landscape::Landscape& landscape) {
  passes::GroundFacts facts;
  facts.snow_m = facts.white_fraction = facts.wetness = [](const glm::dvec2&) { return 0.0; };
  facts.weathering = [](const glm::dvec2&) { return 0.25; };
  facts.albedo = facts.irradiance = [](const glm::dvec2&) { return glm::vec3(0.5F); };
  facts.painted_grass = [](const glm::dvec3&) { return passes::PaintedGrass(); };
  facts.species = {"grass"};
  facts.mixtures = {{1.0}};
  facts.mixture_of_patch = {0};
  facts.next_camera = landscape.camera;
  return facts;
}

}  // namespace wold::test
