// A scene that changes from frame to frame: key frames in its TOML, and the time of day from the command line.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "scenefile/scene_file.h"

namespace airlight {

/// const use is thread-safe; every frame depends on its number alone.
class Animation {
 public:
  /// @param file  for messages; files named inside are looked for beside it
  /// @param frames_per_second  what key frames given by `times` [s] count in
  /// @throws InputError for a scene or key frames that are wrong, at whatever key frame.
  Animation(std::string_view text, const std::string& file, double frames_per_second);
  ~Animation();
  Animation(Animation&&) noexcept;
  Animation& operator=(Animation&&) noexcept;

  /// The sun's time from now on goes evenly from frame 0 to the last one, whatever the scene says of the sun.
  /// @param from, to  ISO 8601, or HH:MM and HH:MM:SS, in UTC on the scene's own day
  /// @param frames    how many
  /// @throws InputError for times that are none, and where the scene animates the sun by itself.
  void set_time_of_day(const std::string& from, const std::string& to, int frames);

  bool animates(std::string_view key) const;  ///< "jetlag.time"
  bool changes_land() const;                  ///< heights, extent or the planet's size

  struct Frame {
    Scene scene;
    std::string text;  ///< the TOML that stands for this frame alone, keys in order: equal for equal frames
  };
  /// @throws InputError naming the frame.
  Frame frame(int number) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// @throws InputError.
Animation load_animation(const std::string& path, double frames_per_second);

}  // namespace airlight
