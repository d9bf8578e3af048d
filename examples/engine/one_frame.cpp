// Makes the scene files of one frame without the command line: one_frame SCENE FRAME OUT
#include <iostream>
#include <string>

#include "core/error.h"
#include "film/exporters.h"
#include "film/film.h"
#include "phenology/film_season.h"
#include "scene/parse.h"

int main(int count, char** words) {
  if (count != 4) {
    std::cerr << "usage: one_frame SCENE FRAME OUT\n";
    return 2;
  }
  try {
    const wold::scene::Scene scene = wold::scene::read_scene(words[1], {});
    const auto season = wold::phenology::film_season(scene);
    const wold::film::Request request{.scene = wold::phenology::as_film(scene, season.get()),
                                      .frames = {std::stoi(words[2])},
                                      .out = words[3],
                                      .exporters = wold::film::wanted_exporters(scene),
                                      .season = season};
    wold::SilentProgress progress;
    for (const auto& file : wold::film::make_film(request, progress))
      std::cout << file.string() << '\n';
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return 1;
  }
}
