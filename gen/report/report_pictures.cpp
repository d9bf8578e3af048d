#include "report/report_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <mutex>

#include "core/error.h"
#include "core/image.h"
#include "core/page_picture.h"
#include "core/parallel.h"

namespace wold::report {
namespace fs = std::filesystem;
namespace {

constexpr double max_bytes = 20e6;  // of JPEG; base64 makes a third more of them
constexpr std::size_t max_frames = 240;

/// From the best to the smallest.
constexpr std::array forms = {PagePicture{1280, 85}, PagePicture{960, 82}, PagePicture{800, 78},
                              PagePicture{640, 75},  PagePicture{480, 72}, PagePicture{320, 65}};

/// Every so manieth frame, so that there are not too many.
std::vector<int> thinned(const std::vector<int>& frames) {
  const std::size_t step = (frames.size() + max_frames - 1) / max_frames;
  std::vector<int> some;
  for (std::size_t i = 0; i < frames.size(); i += step) some.push_back(frames[i]);
  return some;
}

std::vector<int> frames_with_pictures(const ReportFacts& facts) {
  std::vector<int> frames = facts.frames;
  std::erase_if(frames, [&](int frame) {
    return std::ranges::none_of(facts.pictures, [&](const work::FramePictures& pictures) {
      return pictures.by_frame.contains(frame);
    });
  });
  return frames;
}

/// The JPEG's bytes; nothing for a damaged picture.
std::string jpeg_or_nothing(const fs::path& picture, const PagePicture& form) {
  try {
    return jpeg_of(picture, form);
  } catch (const FileError&) {
    return {};
  }
}

/// Mean bytes of some of the pictures.
double mean_bytes(const ReportFacts& facts, const PagePicture& form) {
  std::vector<fs::path> samples;
  for (const work::FramePictures& pictures : facts.pictures)
    for (const std::size_t part : {0, 1, 2})
      samples.push_back(std::next(pictures.by_frame.begin(),
                                  static_cast<long>(part * (pictures.by_frame.size() - 1) / 2))
                            ->second);
  double sum = 0.0;
  for (const fs::path& sample : samples)
    sum += static_cast<double>(jpeg_or_nothing(sample, form).size());
  return sum / static_cast<double>(samples.size());
}

PagePicture form_for(const ReportFacts& facts, std::size_t frames) {
  const double pictures = static_cast<double>(frames * facts.pictures.size());
  for (const PagePicture& form : forms)
    if (mean_bytes(facts, form) * pictures < max_bytes) return form;
  return forms.back();
}

EmbeddedPictures embedded(const work::FramePictures& pictures, const std::vector<int>& frames,
                          const PagePicture& form, Progress& progress) {
  EmbeddedPictures result{pictures.renderer, work::display_name(pictures), {}};
  result.data_uris.resize(frames.size());
  parallel_for(frames.size(), [&](std::size_t i) {
    if (const auto found = pictures.by_frame.find(frames[i]); found != pictures.by_frame.end())
      if (const std::string jpeg = jpeg_or_nothing(found->second, form); !jpeg.empty())
        result.data_uris[i] = data_uri("image/jpeg", jpeg);
    progress.advance(1, fmt::format("{} frame {}", result.display_name, frames[i]));
  });
  return result;
}

void warn_of_damage(const work::FramePictures& pictures, const EmbeddedPictures& embedded,
                    EmbeddedFilm& film) {
  for (std::size_t i = 0; i < film.frames.size(); ++i)
    if (pictures.by_frame.contains(film.frames[i]) && embedded.data_uris[i].empty())
      film.warnings.push_back(
          fmt::format("{} is damaged.", pictures.by_frame.at(film.frames[i]).string()));
}

/// The size of the first picture that has one.
glm::ivec2 first_size(const ReportFacts& facts) {
  for (const work::FramePictures& pictures : facts.pictures)
    for (const auto& [frame, picture] : pictures.by_frame) try {
        const ImageHeader header = read_image_header(picture);
        return {header.width, header.height};
      } catch (const FileError&) {
        continue;
      }
  return {16, 9};
}

}  // namespace

EmbeddedFilm embedded_film(const ReportFacts& facts, Progress& progress) {
  EmbeddedFilm film;
  if (facts.pictures.empty()) return film;
  const std::vector<int> frames = frames_with_pictures(facts);
  film.frames = thinned(frames);
  film.size_px = first_size(facts);
  const PagePicture form = form_for(facts, film.frames.size());
  if (film.frames.size() < frames.size())
    film.warnings.push_back(fmt::format("To keep this page small it shows {} of {} frames.",
                                        film.frames.size(), frames.size()));
  if (film.size_px.x > form.widest_px)
    film.warnings.push_back(fmt::format(
        "To keep this page small its pictures are {} pixels wide, those in the folder {}.",
        form.widest_px, film.size_px.x));
  progress.begin("pictures", film.frames.size() * facts.pictures.size());
  for (const work::FramePictures& pictures : facts.pictures) {
    film.renderers.push_back(embedded(pictures, film.frames, form, progress));
    warn_of_damage(pictures, film.renderers.back(), film);
  }
  progress.end();
  return film;
}

}  // namespace wold::report
