// Any text either is an atmosphere, which survives being written and read again, or is refused with an InputError.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "airlight/error.h"
#include "scenefile/atmosphere_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  airlight::Atmosphere atmosphere;
  try {
    atmosphere = airlight::parse_atmosphere({reinterpret_cast<const char*>(data), size}, "fuzz.toml");
  } catch (const airlight::InputError&) {
    return 0;
  }
  const std::string text = airlight::to_toml(atmosphere);
  if (airlight::parse_atmosphere(text, "again.toml") != atmosphere) {
    std::fprintf(stderr, "not the same when read again:\n%s\n", text.c_str());
    std::abort();
  }
  return 0;
}
