#pragma once

/// Where the Sun stands, for passes that depend on nothing else of an observer: they are not run again when he moves.
struct SunDirection {
  Scalar4 direction;  // [1] in -0.577..0.577  unit vector towards the Sun, z up
};
