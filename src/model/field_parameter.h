// Parameters that are fields of a kernel's struct: unit, range and text are the field's own comment.
#pragma once
#include <string_view>
#include <vector>

#include "model/model.h"
#include "model/parameters.h"

namespace airlight {

/// A Scalar field is a number, a Scalar4 a colour.
ParameterInfo field_parameter(std::string_view struct_name, std::string_view field, ParameterValue otherwise);

/// The fields of a struct from the values of the same names; fields that have none are left out.
Fields struct_fields(std::string_view struct_name, const Values& values);

/// Every field of a struct at 0: for passes that read a few of them.
Fields zero_fields(std::string_view struct_name);

/// The general passes' struct Air for a published system, which has its own: the sum over the sky's light asks for the sunlight before
/// all air, and a system's light holds that already.
Fields unit_air();

}  // namespace airlight
