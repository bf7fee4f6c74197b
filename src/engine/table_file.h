// Tables that took long to make, kept on disk from one run of a program to the next (docs/models/precomputed.md has the format).
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "airlight/engine.h"

namespace airlight {

struct TableFile {
  struct Values {
    Shape shape;
    std::vector<double> rgba;
  };
  std::filesystem::path path;
  std::uint64_t key;  ///< hash of all that the tables were made from
  int number_size;    ///< bytes of a number on disk: 4, 8

  /// None where there is no such file, and where `trouble` says why the one there is not used.
  std::optional<std::vector<Values>> read(std::string& trouble) const;
  /// Replaces the file as a whole or not at all, whoever else writes it. What went wrong; empty: nothing.
  std::string write(const std::vector<Values>& tables) const;
};

}  // namespace airlight
