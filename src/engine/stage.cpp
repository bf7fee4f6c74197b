#include "engine/stage.h"

#include <algorithm>

namespace airlight {

Stage::Stage(Engine& engine, double begin, double end) : engine_(engine), around_(engine.stage_) {
  const double first = around_ ? around_->begin_ : 0, length = around_ ? around_->end_ - first : 1;
  begin_ = first + length * begin;
  end_ = first + length * end;
  engine_.stage_ = this;
}

Stage::~Stage() {
  engine_.stage_ = around_;
  if (around_ || told_ < 0 || !engine_.watch_) return;
  try {
    engine_.watch_(1);
  } catch (...) {  // an exception may be on its way already
  }
}

void Stage::tell() const {
  if (!engine_.watch_) return;
  double& told = outermost().told_;
  told = std::max(told, begin_);
  engine_.watch_(told);
}

}  // namespace airlight
