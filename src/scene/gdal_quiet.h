#pragma once
#include <cpl_error.h>

namespace airlight {

/// While it lives, GDAL prints nothing from this thread: its troubles become exceptions.
struct GdalQuiet {
  GdalQuiet() { CPLPushErrorHandler(CPLQuietErrorHandler), CPLErrorReset(); }
  ~GdalQuiet() { CPLPopErrorHandler(); }
  GdalQuiet(const GdalQuiet&) = delete;
  GdalQuiet& operator=(const GdalQuiet&) = delete;
};

}  // namespace airlight
