// Phase functions from their definitions, apart from those of the models.
#pragma once
#include "airlight/atmosphere.h"

namespace airlight::reference {

/// Phase function [1/sr] at 1 - cos(scattering angle), 0 = forward.
double phase(const Phase& phase, double one_minus_cos);

}  // namespace airlight::reference
