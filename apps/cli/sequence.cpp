// `airlight sequence`: the frames of a scene that changes, as numbered pictures or as a movie.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>

#include "airlight/error.h"
#include "blended_frames.h"
#include "command_line.h"
#include "commands.h"
#include "digest.h"
#include "engine/source_version.h"
#include "frame_names.h"
#include "image/tone.h"
#include "interrupt.h"
#include "model_options.h"
#include "movie.h"
#include "parameter_pictures.h"
#include "progress.h"
#include "scene_render.h"
#include "scenefile/animation.h"
#include "scenefile/atmosphere_file.h"

namespace airlight::cli {
namespace {

namespace fs = std::filesystem;

struct SequenceOptions {
  std::string scene, from, to, frames;
  std::vector<std::string> outputs;
  double frames_per_second = 24;
  int exposure_frame = 0;
  bool keep_frames = false;
  ScenePictureOptions picture;
};

/// What is written: numbered pictures, and movies from numbered pictures in a folder of their own.
struct Outputs {
  struct Movie {
    std::string path, folder;
  };
  std::vector<FrameNames> frames;
  std::vector<Movie> movies;
  bool tone_mapped = false;

  explicit Outputs(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      if (is_movie(path)) {
        movies.push_back({path, path + ".frames"});
        frames.emplace_back(FrameNames((fs::path(path + ".frames") / "%06d.png").string()));
        tone_mapped = true;
        continue;
      }
      const std::string ending = fs::path(path).extension().string();
      if (ending != ".exr" && ending != ".png")
        throw InputError(fmt::format("-o {}: expected .exr, .png, .mp4, .mov or .mkv", path));
      frames.emplace_back(path);
      tone_mapped |= ending == ".png";
    }
    for (const Movie& movie : movies) require_ffmpeg(movie.path);
  }

  std::vector<std::string> names(int frame) const {
    std::vector<std::string> names;
    for (const FrameNames& pattern : frames) names.push_back(pattern.name(frame));
    return names;
  }
};

constexpr char digest_key[] = "frame digest";

/// Files are renamed into place, so one that is there is whole; its header says what it shows.
bool is_made(const std::string& path, const std::string& digest) {
  std::ifstream file(path, std::ios::binary);
  std::string head(1 << 16, '\0');
  file.read(head.data(), std::streamsize(head.size()));
  head.resize(std::size_t(file.gcount()));
  return head.find(digest) != std::string::npos;
}

class Sequence {
 public:
  explicit Sequence(const SequenceOptions& options)
      : options_(options),
        range_(parse_frames(options.frames)),
        outputs_(options.outputs),
        layers_(options.picture.layers(options.outputs)),
        animation_(load_animation(options.scene, options.frames_per_second)),
        engine_(engine_named(options.picture.engine)) {
    if (!options.from.empty()) {
      if (range_.total == 0)
        throw InputError(fmt::format("--frames = {}: with --from and --to, say how many frames there are in all: {}/N",
                                     options.frames, options.frames));
      animation_.set_time_of_day(options.from, options.to, range_.total);
    }
    check_frames();
  }

  int run() {
    const auto started = std::chrono::steady_clock::now();
    for (const Outputs::Movie& movie : outputs_.movies) fs::create_directories(movie.folder);
    int made = 0;
    {
      Progress progress("sequence");
      for (int number = range_.first; number <= range_.last; ++number) {
        const auto tell = [&](double part) { progress.show((number - range_.first + part) / range_.count()); };
        made += make_frame(number, tell);
        tell(1);
        if (interrupted()) throw_interrupted();
      }
    }
    for (const Outputs::Movie& movie : outputs_.movies) {
      encode_movie(movie.path, FrameNames((fs::path(movie.folder) / "%06d.png").string()).pattern(), range_.first,
                   range_.count(), options_.frames_per_second);
      if (!options_.keep_frames) fs::remove_all(movie.folder);
    }
    std::string names;
    for (const std::string& path : options_.outputs) names += (names.empty() ? "" : ", ") + path;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    fmt::print(stderr, "{}: frames {} to {}, {} made, {} there already, on {}; {:.2f} s\n", names, range_.first,
               range_.last, made, range_.count() - made, describe(*engine_), seconds);
    if (exposure_ev_)
      fmt::print(stderr, "exposure of all frames: EV {:+.2f}, automatic for frame {}\n", *exposure_ev_,
                 options_.exposure_frame);
    return ok;
  }

 private:
  Scene scene_of(const Animation::Frame& frame, int number) const {
    Scene scene = frame.scene;
    options_.picture.apply(scene);
    number_frame(scene, number, animation_, options_.frames_per_second);
    return scene;
  }

  /// Land is costly; it is made once unless it changes, too.
  std::shared_ptr<const Land> land_of(const Scene& scene) {
    if (!land_ || animation_.changes_land()) land_ = std::make_shared<const Land>(scene.land);
    return land_;
  }

  /// Everything that can be wrong with any frame is found before a file is touched.
  void check_frames() {
    int width = 0, height = 0;
    for (int number = range_.first; number <= range_.last; ++number) {
      check_interrupt();
      const Scene scene = scene_of(animation_.frame(number), number);
      options_.picture.format(scene);
      try {
        place_camera(scene.camera, *land_of(scene));
      } catch (const InputError& error) {
        throw InputError(fmt::format("{} (frame {})", error.what(), number));
      }
      const Camera& camera = scene.camera.camera;
      if (number == range_.first) width = camera.width, height = camera.height;
      const std::string at = fmt::format("frame {} is {} x {} pixels: ", number, camera.width, camera.height);
      if (camera.width != width || camera.height != height)
        throw InputError(fmt::format("{}expected {} x {} as in frame {}", at, width, height, range_.first));
      if (!outputs_.movies.empty() && (width % 2 != 0 || height % 2 != 0))
        throw InputError(at + "a movie's sides are even numbers (--size)");
    }
  }

  /// The automatic exposure of one frame for all: chosen for each alone, it would flicker. Measured on a small picture,
  /// and rounded, so that every run and machine finds the same.
  double exposure() {
    if (exposure_ev_) return *exposure_ev_;
    Scene scene = scene_of(animation_.frame(options_.exposure_frame), options_.exposure_frame);
    Camera& camera = scene.camera.camera;
    const int width = std::min(camera.width, 160);
    camera.height = std::max(1, int(std::lround(double(width) * camera.height / camera.width)));
    camera.width = width;
    scene.picture.samples = 1;
    const SceneShot shot(scene, land_of(scene), engine_, !options_.picture.no_sun);
    std::vector<float> rgb;
    shot.rows([&](int, std::span<const float> strip) {
      rgb.insert(rgb.end(), strip.begin(), strip.end());
      return true;
    });
    exposure_ev_ = std::round(automatic_exposure(rgb) * 100) / 100;
    return *exposure_ev_;
  }

  std::string digest_of(int number, const Animation::Frame& frame, const Scene& scene, const PictureFormat& format) {
    Digest digest;
    const ScenePictureOptions& p = options_.picture;
    for (const std::string& piece :
         {std::string(version()), std::to_string(source_version()), std::to_string(number), frame.text,
          to_toml(scene.air), p.size, p.aov, p.engine, scene.picture.model, scene.picture.tone,
          std::to_string(scene.picture.samples), std::to_string(p.full_float), std::to_string(p.no_sun),
          std::to_string(p.no_air_shadows),
          format.exposure_ev ? fmt::format("{}", *format.exposure_ev) : std::string("auto")})
      digest.add(piece);
    if (const auto own = frame.scene.parameters.find(scene.picture.model); own != frame.scene.parameters.end())
      for (const std::string& file : picture_files(scene.picture.model, own->second)) digest.add(content(file));
    if (const auto gathering = gathering_of(scene)) {
      digest.add(fmt::format("{} {}", p.accumulate.value_or(0), options_.frames_per_second));
      for (int before = 1; gathering->weight > 0 && before <= BlendedFrames::run_in; ++before)
        digest.add(animation_.frame(number - before).text);
    }
    for (const ElevationFile& file : scene.land.files) digest.add(content(file.file));
    if (!scene.surface.image.empty()) digest.add(content(scene.surface.image));
    return digest.text();
  }
  const std::string& content(const std::string& path) {
    auto [entry, added] = contents_.try_emplace(path);
    if (added) {
      Digest digest;
      digest.add_file(path);
      entry->second = digest.text();
    }
    return entry->second;
  }

  /// @returns false where it was there
  bool make_frame(int number, const std::function<void(double)>& progress) {
    const Animation::Frame frame = animation_.frame(number);
    const Scene scene = scene_of(frame, number);
    PictureFormat format = options_.picture.format(scene);
    if (outputs_.tone_mapped && !format.exposure_ev) format.exposure_ev = exposure();
    const std::string digest = digest_of(number, frame, scene, format);
    const std::vector<std::string> names = outputs_.names(number);
    if (std::ranges::all_of(names, [&](const std::string& name) { return is_made(name, digest); })) return false;

    const SceneShot shot(scene, land_of(scene), engine_, !options_.picture.no_sun);
    for (const std::string& warning : shot.warnings())
      if (told_.insert(warning).second) tell_warnings({warning});
    Metadata metadata = shot.metadata();
    metadata.push_back({"engine", std::string(engine_->name())});
    metadata.push_back({"frame", double(number)});
    metadata.push_back({digest_key, digest});
    PictureOutputs files(names, shot.width(), shot.height(), format, metadata);
    try {
      const auto gathering = gathering_of(scene);
      if (gathering && gathering->weight > 0)
        paint_blended(files, number, shot, *gathering, progress);
      else
        shot.paint(files, layers_, progress);
    } catch (const Interrupted&) {
      throw_interrupted();
    }
    return true;
  }

  void paint_blended(PictureOutputs& files, int number, const SceneShot& shot, const Gathering& gathering,
                     const std::function<void(double)>& progress) {
    if (!layers_.empty()) shot.paint(files, layers_, progress);  // says that there are none
    const int first = blended_.first_for(number), count = number - first + 1;
    const auto draw = [&](int at) {
      if (at == number) return rgba(shot, (at - first) / double(count), 1.0 / count, progress);
      const SceneShot before(scene_of(animation_.frame(at), at), land_, engine_, !options_.picture.no_sun);
      return rgba(before, (at - first) / double(count), 1.0 / count, progress);
    };
    files.write(0, shot.height(), blended_.frame(number, gathering, draw));
    files.finish();
  }
  static std::vector<float> rgba(const SceneShot& shot, double begin, double part,
                                 const std::function<void(double)>& progress) {
    std::vector<float> pixels;
    const bool whole = shot.rows([&](int end, std::span<const float> rgb) {
      for (std::size_t i = 0; i < rgb.size(); i += 3) pixels.insert(pixels.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 1});
      progress(begin + part * end / shot.height());
      return !interrupted();
    });
    if (!whole) throw Interrupted{};
    return pixels;
  }

  [[noreturn]] static void throw_interrupted() {
    throw Interrupted("frames that are made stay, and the same command goes on from there");
  }

  const SequenceOptions& options_;
  const FrameRange range_;
  const Outputs outputs_;
  const std::vector<Layer> layers_;
  Animation animation_;
  std::shared_ptr<Engine> engine_;
  std::shared_ptr<const Land> land_;
  std::optional<double> exposure_ev_;
  std::map<std::string, std::string> contents_;
  BlendedFrames blended_;
  std::set<std::string> told_;  // of warnings
};

}  // namespace

void add_sequence(CommandLine& line) {
  const auto options = std::make_shared<SequenceOptions>();
  const Verb sequence =
      line.verb("sequence", "The frames of a scene that changes: time of day, key frames; a movie of them");
  sequence.option("scene", options->scene, "scene with its key frames, TOML (docs/scene_file.md)")
      .required()
      .type_name("FILE");
  sequence
      .option("-o,--output", options->outputs,
              "frames_%04d.exr or .png, the number in place of %04d; or a movie, .mp4, .mov or .mkv, which needs "
              "ffmpeg; may be repeated")
      .required()
      .one_value_each()
      .type_name("FILE");
  sequence
      .option("--frames", options->frames,
              "how many, N; or FIRST:LAST of them, both made, counted from 0 (FIRST:LAST/N with --from)")
      .required()
      .type_name("N");
  const Option from = sequence
                          .option("--from", options->from,
                                  "the sun's time in the first frame: 2026-06-21T04:30Z, or 04:30, in UTC on the "
                                  "day of the scene's own time")
                          .type_name("TIME");
  const Option to = sequence.option("--to", options->to, "the sun's time in the last frame").type_name("TIME");
  from.needs(to);
  to.needs(from);
  sequence.number("--fps", options->frames_per_second, {0.001, 1000, "1/s"},
                  "frames a second, of a movie and of key frames that are given by times");
  sequence.number("--exposure-frame", options->exposure_frame, {0, 1e8, "frames"},
                  "the frame whose automatic exposure all get");
  sequence.flag("--keep-frames", options->keep_frames, "leave the frames of a movie in MOVIE.frames/");
  options->picture.add_to(sequence);
  sequence.runs([options] { return Sequence(*options).run(); });
}

}  // namespace airlight::cli
