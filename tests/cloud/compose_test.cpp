#include "cloud/compose.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

using scene::CloudEventKind;
using scene::CloudFade;

constexpr double pixel_m = 50.0;

scene::Scene one_layer() {
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].cell_m = 3200.0;
  scene.clouds[0].cells = {3, 2};
  return scene;
}

const SkyWindow window{{-700.0, 300.0}, 192, 128};

double mean_opacity(const Image& image) {
  double sum = 0.0;
  for (std::size_t i = 3; i < image.values.size(); i += 4) sum += image.values[i];
  return sum / (image.width * image.height);
}

TEST(Compose, ShowsTheOpacityOfTheLayersDepth) {
  scene::Scene scene = one_layer();
  scene.clouds[0].heading_deg = 33.0;
  scene.clouds[0].light = scene::Law::paper;
  const CloudState state = Clouds(scene, pixel_m).at(123.0);
  const Image image = composed(state, window);
  for (int y = 0; y < window.height_px; y += 7)
    for (int x = 0; x < window.width_px; x += 5) {
      const glm::dvec2 place =
          window.south_west_m + pixel_m * glm::dvec2(x + 0.5, window.height_px - 1 - y + 0.5);
      const double depth = optical_depth_at(state.layers[0], pixel_m, place);
      const float* pixel = image.pixel(x, y);
      EXPECT_NEAR(pixel[3], -std::expm1(-depth), 0.01);
      EXPECT_FLOAT_EQ(pixel[0], pixel[3]);  // white clouds, premultiplied
    }
}

TEST(Compose, CoversTheShareOfTheSkyThatTheSceneSays) {
  scene::Scene scene = one_layer();
  for (const double cover : {0.2, 0.5, 0.8}) {
    scene.clouds[0].cover = cover;
    const CloudState state = Clouds(scene, pixel_m).at(0.0);
    const Image image = layer_picture(state.layers[0], pixel_m);
    std::size_t covered = 0;
    for (std::size_t i = 3; i < image.values.size(); i += 4) covered += image.values[i] > 0.0F;
    EXPECT_NEAR(static_cast<double>(covered) / (image.width * image.height), cover, 0.06);
  }
}

TEST(Compose, DriftMovesThePictureByMetresPerSecond) {
  scene::Scene scene = one_layer();
  scene.clouds[0].speed_m_s = 10.0;  // to the east
  const Clouds clouds(scene, pixel_m);
  const Image before = composed(clouds.at(0.0), window);
  const Image after = composed(clouds.at(35.0), window);  // seven pixels
  for (int y = 0; y < window.height_px; ++y)
    for (int x = 7; x < window.width_px; ++x)
      for (int c = 0; c < 4; ++c)
        EXPECT_EQ(after.pixel(x, y)[c], before.pixel(x - 7, y)[c]) << x << ' ' << y;
  scene.clouds[0].heading_deg = 0.0;
  const Image north = composed(Clouds(scene, pixel_m).at(35.0), window);
  for (int y = 7; y < window.height_px; ++y)
    EXPECT_EQ(north.pixel(50, y - 7)[3], before.pixel(50, y)[3]);
}

TEST(Compose, ALayerRepeatsAfterItsPeriod) {
  const CloudState state = Clouds(one_layer(), pixel_m).at(77.0);
  const glm::dvec2 period = state.layers[0].layer->period_m;
  EXPECT_EQ(period, glm::dvec2(9600.0, 6400.0));
  SkyWindow other = window;
  other.south_west_m += period * glm::dvec2(2.0, -3.0);
  const Image here = composed(state, window), there = composed(state, other);
  for (std::size_t i = 0; i < here.values.size(); ++i)
    EXPECT_NEAR(here.values[i], there.values[i], 1.0 / 255.0);  // an entry of the look
}

// A season's sun sinks from frame to frame, and the clouds are lit by it.
TEST(Compose, FramesAndThreadsDoNotMatter) {
  scene::Scene scene = one_layer();
  scene.clouds.push_back(scene.clouds[0]);
  scene.clouds[1].kind = scene::CloudKind::cirrus;
  scene.clouds[1].gusts_m_s = 2.0;
  scene.cloud_events = {
      {.kind = CloudEventKind::wind, .start_s = 100, .duration_s = 500, .heading_deg = 200},
      {.kind = CloudEventKind::gather, .start_s = 100, .duration_s = 100}};
  const auto sun_of = [](int frame) {
    return glm::normalize(glm::dvec3(0.5, -1.0, 1.2 - 0.01 * frame));
  };
  const auto frame_alone = [&](int frame) {
    return composed(Clouds(scene, pixel_m).at(10.0 * (frame - 1), sun_of(frame)), window).values;
  };
  const Clouds film(scene, pixel_m);
  std::vector<float> fiftieth;
  for (int frame = 1; frame <= 50; frame += 7)
    fiftieth = composed(film.at(10.0 * (frame - 1), sun_of(frame)), window).values;
  EXPECT_EQ(fiftieth, frame_alone(50));
  const ThreadLimit one(1);
  EXPECT_EQ(fiftieth, frame_alone(50));
}

TEST(Compose, OpacityIsMonotoneWhileCloudsGatherAndDissipate) {
  for (const CloudFade fade : {CloudFade::optical, CloudFade::paper}) {
    scene::Scene scene = one_layer();
    scene.clouds[0].gathered = 0.0;
    scene.clouds[0].speed_m_s = 0.0;
    scene.cloud_events = {
        {.kind = CloudEventKind::gather, .start_s = 0, .duration_s = 100, .fade = fade},
        {.kind = CloudEventKind::dissipate, .start_s = 100, .duration_s = 100, .fade = fade}};
    const Clouds clouds(scene, pixel_m);
    EXPECT_EQ(mean_opacity(composed(clouds.at(0.0), window)), 0.0);
    Image last = composed(clouds.at(0.0), window);
    for (int time_s = 10; time_s <= 200; time_s += 10) {
      const Image next = composed(clouds.at(time_s), window);
      const bool gathers = time_s <= 100;
      for (std::size_t i = 3; i < next.values.size(); i += 4)
        EXPECT_TRUE(gathers ? next.values[i] >= last.values[i] : next.values[i] <= last.values[i]);
      EXPECT_NE(mean_opacity(next), mean_opacity(last)) << time_s;
      last = next;
    }
    EXPECT_EQ(mean_opacity(last), 0.0);
  }
}

/// Largest opacity in the middle of a wind that would turn the clouds into themselves.
double opacity_half_way(CloudFade fade) {
  scene::Scene scene = one_layer();
  scene.cloud_events = {
      {.kind = CloudEventKind::wind, .duration_s = 100, .shear = 1e-9, .fade = fade}};
  CloudState state = Clouds(scene, pixel_m).at(50.0);
  state.layers[0].next_map = state.layers[0].map;
  const Image image = composed(state, window);
  float max = 0.0F;
  for (std::size_t i = 3; i < image.values.size(); i += 4) max = std::max(max, image.values[i]);
  return max;
}

TEST(Compose, OpticalDepthsFadeWithoutThePapersDip) {
  EXPECT_NEAR(opacity_half_way(CloudFade::optical), 0.99, 0.003);
  EXPECT_NEAR(opacity_half_way(CloudFade::paper), 1.0 - 0.505 * 0.505,
              0.003);  // 3/4 of an opaque cloud
}

TEST(Compose, LowerLayersHideHigherOnes) {
  scene::Scene scene = one_layer();
  scene.clouds.push_back(scene.clouds[0]);
  scene.clouds[0].base_m = 500.0;  // a dark one below a white one
  scene.clouds[0].light = scene::Law::paper;
  scene.clouds[1].light = scene::Law::paper;
  for (auto& layer : scene.clouds) layer.speed_m_s = 0.0;
  scene.cloud_events = {
      {.kind = CloudEventKind::light, .layer = 1, .duration_s = 1.0, .colour = {0, 0, 0}}};
  const CloudState state = Clouds(scene, pixel_m).at(2.0);
  ASSERT_EQ(state.layers[1].layer->base_m, 500.0);
  const Image both = composed(state, window);
  CloudState upper = state, lower = state;
  upper.layers.pop_back();
  lower.layers.erase(lower.layers.begin());
  const Image far = composed(upper, window), near = composed(lower, window);
  for (std::size_t i = 0; i < both.values.size(); i += 4) {
    const float through = 1.0F - near.values[i + 3];
    EXPECT_NEAR(both.values[i], through * far.values[i], 1e-6);
    EXPECT_NEAR(1.0F - both.values[i + 3], through * (1.0F - far.values[i + 3]), 1e-6);
  }
}

TEST(Compose, ThickBasesAreDarkerThanEdges) {
  scene::Scene scene = one_layer();
  scene.sun.elevation_deg = 90.0;
  const CloudState state = Clouds(scene, pixel_m).at(0.0);
  const Image image = layer_picture(state.layers[0], pixel_m);
  double thick = 1.0, thin = 0.0;
  for (std::size_t i = 0; i < image.values.size(); i += 4) {
    const double alpha = image.values[i + 3];
    if (alpha > 0.98) thick = std::min(thick, image.values[i] / alpha);
    if (alpha > 0.01 && alpha < 0.1) thin = std::max(thin, image.values[i] / alpha);
  }
  // Two-stream, 1 / (1 + 3/4 (1 - 0.866) 120 * 0.5), and the ground's fifth of the rest.
  EXPECT_NEAR(thick, 0.142 + 0.2 * (1.0 - 0.142), 0.01);
  EXPECT_GT(thin, 0.8);
}

TEST(Clouds, RefuseMoreThanTheyCanHold) {
  scene::Scene scene = one_layer();
  EXPECT_THROW(Clouds(scene, 0.1), InputError);
  EXPECT_TRUE(Clouds(scene::Scene{}, pixel_m).at(0.0).layers.empty());
  EXPECT_EQ(Clouds::usual_pixel_m(scene.clouds), 3200.0 / 256);
  scene.clouds[0].body = scene::CloudBody::volume;
  EXPECT_EQ(Clouds::usual_pixel_m(scene.clouds), 3200.0 / 256);  // heads have what is finer
  scene.clouds[0].kind = scene::CloudKind::stratus;
  EXPECT_EQ(Clouds::usual_pixel_m(scene.clouds), 3200.0 / 512);
}

TEST(Clouds, OfAnyScalesLieOverEachOther) {
  scene::Scene scene = one_layer();
  scene.clouds[0].cell_m = 10.0;  // far smaller than a pixel
  scene.clouds.push_back(scene.clouds[0]);
  scene.clouds[1].cell_m = 100000.0;
  scene.clouds[1].cells = {1, 64};
  scene.cloud_events = {
      {.kind = CloudEventKind::faster, .start_s = 5, .duration_s = 0.001, .factor = 100}};
  const double usual_m = Clouds::usual_pixel_m(scene.clouds);
  EXPECT_NEAR(usual_m, 64 * 100000.0 / 2048.0, 1e-9);
  const Clouds clouds(scene, 4.0 * usual_m);
  for (const double time_s : {0.0, 5.0005, 1e9}) {
    const Image image = composed(clouds.at(time_s), window);
    for (const float value : image.values) EXPECT_TRUE(value >= 0.0F && value <= 1.0F);
  }
}

TEST(Clouds, AClearSkyComposesToNothing) {
  const Image image = composed(Clouds(scene::Scene{}, pixel_m).at(0.0), window);
  EXPECT_EQ(image.values, std::vector<float>(image.values.size(), 0.0F));
}

}  // namespace
}  // namespace wold::cloud
