// Pictures among a model's parameters: painted tables.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "airlight/parameters.h"

namespace airlight::cli {

/// Files that parameters of a model name.
std::vector<std::string> picture_files(std::string_view model, const Parameters& given);

/// Reads them. @throws InputError naming the parameter, the file and the reason
void read_pictures(std::string_view model, Parameters& given);

/// One painted table. @throws InputError
ParameterPicture read_painted(const std::string& path);

/// Writes one: .png of 8 bits, its colours encoded as sRGB and alpha as it is, or .exr of floats.
/// @throws InputError for another ending, before anything is written
void write_painted(const std::string& path, const ParameterPicture& picture);

}  // namespace airlight::cli
