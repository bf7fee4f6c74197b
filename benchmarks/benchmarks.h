// The benchmarks, in the order in which they run. Each checks its answer, then, if the report is to have times, times it.
#pragma once
#include "engines.h"
#include "report.h"

namespace airlight::bench {

/// exps, divisions and texels of every instruction set.
MachineLimits measure_limits(Report& report);
/// The 16 x 4-step march, one float at a time and in each instruction set.
void march(Report& report, const MachineLimits& limits);
/// `skyview` under a moving sun at 1920 x 1080, in processor time of all threads; then pictures on one thread, a pixel.
void pictures(Report& report, const MachineLimits& limits);
/// Pictures of the published systems on one thread, a pixel.
void published(Report& report, const MachineLimits& limits);
/// The tables of an atmosphere from nothing.
void tables(Report& report);
/// Batches of rays on one thread, a ray.
void rays(Report& report, const MachineLimits& limits);
/// `precomputed`'s answers to rays, by its kernel alone.
void precomputed(Report& report);
/// `airlight sky`, as a whole process.
void command(Report& report);

}  // namespace airlight::bench
