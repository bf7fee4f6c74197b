// The ending of a message about an unknown name: "; did you mean earth?".
#pragma once
#include <algorithm>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace airlight {

/// Edits (insertions, deletions, replacements) that turn one word into another.
inline std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// The known name that a wrong one was probably meant to be: a slip of the finger away, or the only one that begins like it; empty: none.
/// @param known  any range of names, which live longer than the answer
template <typename Names>
std::string_view nearest_name(std::string_view wrong, const Names& known) {
  std::string_view nearest, longer;
  // A third of the letters may be wrong, but not all: enough for slips of the finger, too little to turn "mars" into "earth".
  std::size_t best = std::min(wrong.size() / 3 + 1, std::max<std::size_t>(wrong.size(), 1) - 1);
  int begin_so = 0;
  for (const std::string_view name : known) {
    if (wrong.size() >= 3 && name.starts_with(wrong)) longer = name, ++begin_so;
    // Words of very different length cannot be near; this also bounds the work on hostile input.
    if (wrong.size() > name.size() + best || name.size() > wrong.size() + best) continue;
    const std::size_t distance = edit_distance(wrong, name);
    if (distance < best || (distance == best && nearest.empty())) {
      best = distance;
      nearest = name;
    }
  }
  return nearest.empty() && begin_so == 1 ? longer : nearest;
}

/// "; did you mean X?" with the nearest known name, or "; expected one of A, B, C" where none is near.
template <typename Names>
std::string did_you_mean(std::string_view wrong, const Names& known) {
  if (const std::string_view nearest = nearest_name(wrong, known); !nearest.empty())
    return "; did you mean " + std::string(nearest) + "?";
  std::string all;
  for (const std::string_view name : known) all += (all.empty() ? "" : ", ") + std::string(name);
  return "; expected one of " + all;
}

}  // namespace airlight
