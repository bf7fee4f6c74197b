// Which part of a long work the passes to come are: what Engine::watch() is told.
#pragma once
#include "airlight/engine.h"

namespace airlight {

/// While it lives, passes are the part of the work from `begin` to `end`, 0 to 1, of the stage around it, or of all.
class Stage {
 public:
  Stage(Engine& engine, double begin, double end);
  /// One of so many equal parts.
  Stage(Engine& engine, std::size_t part, std::size_t parts)
      : Stage(engine, double(part) / double(parts), double(part + 1) / double(parts)) {}
  ~Stage();  ///< the outermost one ends the work
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Tells whoever watches how far the work is; never less than was told before. @throws what the watch throws
  void tell() const;

 private:
  Engine& engine_;
  const Stage* const around_;
  double begin_, end_;        // of all
  mutable double told_ = -1;  // the outermost one's: nothing yet
  const Stage& outermost() const { return around_ ? around_->outermost() : *this; }
};

}  // namespace airlight
