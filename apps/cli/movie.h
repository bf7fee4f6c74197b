// Movies, encoded by the program ffmpeg.
#pragma once
#include <string>

namespace airlight::cli {

/// .mp4, .mov or .mkv
bool is_movie(const std::string& path);

/// @throws WorkError where there is no ffmpeg.
void require_ffmpeg(const std::string& path);

/// Encodes numbered PNG files (H.264, 8 bits, BT.709) and renames the movie into place when it is whole.
/// @param frames  their names, with %06d for the number
/// @throws WorkError with what ffmpeg said; Interrupted
void encode_movie(const std::string& path, const std::string& frames, int first, int count, double frames_per_second);

}  // namespace airlight::cli
