#include "scenefile/animation.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "airlight/error.h"
#include "did_you_mean.h"
#include "optics/number_text.h"
#include "scene/sun_position.h"
#include "scenefile/key_frames.h"
#include "scenefile/scene_toml.h"
#include "scenefile/text_file.h"
#include "scenefile/toml_text.h"

namespace airlight {
namespace {

constexpr std::string_view time_key = "sun.time";

/// Key frames of one key; those of the time count seconds from `start`.
struct Track {
  std::string key;
  std::string location;  ///< "scene.toml:40: animate[1].key"
  KeyFrames keys;        ///< over frame numbers
  std::optional<Time> start;
};

double seconds_between(const Time& from, const Time& to) {
  return 86'400 * ((to.day - from.day) + (to.fraction - from.fraction));
}
Time later(const Time& start, double seconds) { return {start.day, start.fraction + seconds / 86'400}; }

void read_times(TableReader& reader, Track& track) {
  for (const toml::node& node : reader.array("values")) {
    const std::string item = "values[" + std::to_string(track.keys.values.size()) + "]";
    if (!node.is_string()) reader.fail(item, ": expected a string, an ISO 8601 time, as the key is sun.time");
    try {
      const Time time = parse_time(node.as_string()->get());
      if (!track.start) track.start = time;
      track.keys.values.push_back(seconds_between(*track.start, time));
    } catch (const InputError& error) {
      reader.fail(item, std::string(": ") + error.what());
    }
  }
}

Track read_track(TableReader& reader, double frames_per_second) {
  Track track;
  track.key = reader.text("key");
  track.location = reader.location("key");
  const bool by_frames = reader.has("frames"), by_times = reader.has("times");
  if (by_frames == by_times) reader.fail("frames", ": expected either this or times [s]");
  const std::string_view axis = by_frames ? "frames" : "times";
  track.keys.at = reader.numbers(axis);
  for (double& at : track.keys.at) at *= by_frames ? 1 : frames_per_second;
  if (track.keys.at.empty()) reader.fail(axis, ": expected one number at least");
  for (std::size_t i = 0; i < track.keys.at.size(); ++i) {
    constexpr double most = 1e9;  // frames are counted in an int
    const double at = track.keys.at[i];
    if (!(at >= -most && at <= most) || (i > 0 && !(at > track.keys.at[i - 1])))
      reader.fail(axis, std::string("[") + std::to_string(i) +
                            "]: expected numbers that grow, within 1e9 frames of the first frame");
  }
  if (track.key == time_key) {
    read_times(reader, track);
  } else {
    track.keys.values = reader.numbers("values");
  }
  if (track.keys.values.size() != track.keys.at.size())
    reader.fail("values", ": expected " + std::to_string(track.keys.at.size()) + ", as many as " + std::string(axis) +
                              ", got " + std::to_string(track.keys.values.size()));
  constexpr std::string_view names[] = {"linear", "smooth"};
  const std::string name = reader.has("interpolation") ? reader.text("interpolation") : "linear";
  if (std::find(std::begin(names), std::end(names), name) == std::end(names))
    reader.fail("interpolation", " = " + toml_text(name) + ": unknown" + did_you_mean(name, names));
  track.keys.interpolation = name == "smooth" ? KeyFrames::Interpolation::smooth : KeyFrames::Interpolation::linear;
  reader.finish();
  return track;
}

/// Puts a value at a key, "camera.altitude" or "camera.position[1]"; a table's key need not be there yet.
template <typename Value>
void put(toml::table& document, const Track& track, const Value& value) {
  const std::string& key = track.key;
  const auto refuse = [&](const std::string& why) {
    throw InputError(track.location + " = " + toml_text(key) + ": " + why);
  };
  if (key.ends_with(']')) {
    const std::size_t open = key.rfind('[');
    toml::node* const list = open == std::string::npos ? nullptr : toml::at_path(document, key.substr(0, open)).node();
    const toml::node* const item = toml::at_path(document, key).node();
    if (!list || !list->is_array() || !item) refuse("there is no such number in the scene");
    if (!item->is_number()) refuse("expected a key that holds a number");
    toml::array& numbers = *list->as_array();
    for (auto it = numbers.begin(); it != numbers.end(); ++it) {
      if (&*it != item) continue;
      numbers.replace(it, value);
      return;
    }
  }
  const std::size_t dot = key.rfind('.');
  toml::node* parent = &document;
  if (dot != std::string::npos) {
    const std::string name = key.substr(0, dot);
    parent = toml::at_path(document, name).node();
    if (!parent && name.find_first_of(".[") == std::string::npos)
      parent = &document.insert(name, toml::table{}).first->second;
  }
  if (!parent || !parent->is_table()) refuse("there is no such table in the scene");
  toml::table& table = *parent->as_table();
  const std::string last = dot == std::string::npos ? key : key.substr(dot + 1);
  if (const toml::node* before = table.get(last); before && !before->is_number() && !before->is_string())
    refuse("expected a key that holds a number");
  table.insert_or_assign(last, value);
}

}  // namespace

struct Animation::Impl {
  std::string text, file;
  std::vector<Track> tracks;
  bool time_of_day = false;

  // Parsed anew for every frame: a copy of toml++'s tables forgets its line numbers, which messages need.
  toml::table document_at(double frame) const {
    toml::table changed = parse_toml(text, file);
    changed.erase("animate");
    if (toml::table* sun = changed["sun"].as_table(); sun && time_of_day) {
      for (const char* angle : {"elevation", "azimuth"}) sun->erase(angle);
    }
    for (const Track& track : tracks) {
      const double value = track.keys.value(frame);
      if (track.start)
        put(changed, track, format_time(later(*track.start, value)));
      else
        put(changed, track, value);
    }
    return changed;
  }

  Frame frame(double number) const {
    const toml::table changed = document_at(number);
    try {
      std::ostringstream written;
      written << changed;
      return {read_scene(changed, file), written.str()};
    } catch (const InputError& error) {
      if (tracks.empty()) throw;
      throw InputError(std::string(error.what()) + " (frame " + number_text(number) + ")");
    }
  }
};

Animation::Animation(std::string_view text, const std::string& file, double frames_per_second)
    : impl_(std::make_unique<Impl>()) {
  impl_->text = text;
  impl_->file = file;
  const toml::table document = parse_toml(text, file);
  TableReader root(document, file);
  if (root.has("animate")) {
    for (TableReader& reader : root.tables("animate")) {
      Track track = read_track(reader, frames_per_second);
      for (const Track& other : impl_->tracks)
        if (other.key == track.key) reader.fail("key", " = " + toml_text(track.key) + ": animated twice");
      impl_->tracks.push_back(std::move(track));
    }
  }
  impl_->frame(0);
  // No value leaves the range of its keys, so what is legal at all keys is legal between.
  for (const Track& track : impl_->tracks)
    for (const double at : track.keys.at) impl_->frame(at);
}

Animation::~Animation() = default;
Animation::Animation(Animation&&) noexcept = default;
Animation& Animation::operator=(Animation&&) noexcept = default;

void Animation::set_time_of_day(const std::string& from, const std::string& to, int frames) {
  for (const Track& track : impl_->tracks)
    if (track.key.starts_with("sun."))
      throw InputError(track.location + " = " + toml_text(track.key) +
                       ": expected no key frames of the sun where a time of day is given");
  const auto time = [&](const std::string& text) {
    if (text.find('T') != std::string::npos) return parse_time(text);
    const std::optional<Time> own = impl_->frame(0).scene.sun.time;
    if (!own)
      throw InputError("'" + text +
                       "': expected a time with its day, 2026-06-21T04:30Z, as the scene's sun has no time");
    return parse_time(format_time(*own).substr(0, 11) + text + "Z");
  };
  const Time start = time(from), end = time(to);
  impl_->time_of_day = true;
  Track track{std::string(time_key), impl_->file, {{0}, {0}}, start};
  if (frames > 1) {
    track.keys.at.push_back(frames - 1);
    track.keys.values.push_back(seconds_between(start, end));
  }
  impl_->tracks.push_back(std::move(track));
  impl_->frame(0);
}

bool Animation::animates(std::string_view key) const {
  return std::ranges::find(impl_->tracks, key, &Track::key) != impl_->tracks.end();
}

bool Animation::changes_land() const {
  // Of lights, the camera, the ground's colour and the picture land knows nothing.
  return !std::ranges::all_of(impl_->tracks, [](const Track& track) {
    const std::string_view part = std::string_view(track.key).substr(0, track.key.find_first_of(".["));
    return part == "sun" || part == "light" || part == "camera" || part == "surface" || part == "picture";
  });
}

Animation::Frame Animation::frame(int number) const { return impl_->frame(number); }

Animation load_animation(const std::string& path, double frames_per_second) {
  const auto text = read_text_file(path);
  if (!text) throw InputError(path + ": no such file");
  return {*text, path, frames_per_second};
}

}  // namespace airlight
