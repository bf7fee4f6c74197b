# Lines of `probe --batch` and `eval`.
set(commands ${PROJECT_SOURCE_DIR}/apps/cli)
airlight_add_fuzz_test(jsonl
  SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/fuzz_jsonl.cpp ${shipped_data}
          ${commands}/batch_plane_parallel.cpp ${commands}/batch_request.cpp ${commands}/eval_request.cpp
          ${commands}/json_line.cpp ${commands}/json_phase.cpp ${commands}/number.cpp ${commands}/question.cpp
          ${commands}/reference_request.cpp
          ${core}/atmosphere.cpp ${core}/coefficients.cpp ${core}/csv.cpp ${core}/presets.cpp ${core}/profile.cpp
          ${core}/rayleigh_air.cpp ${core}/spectrum.cpp ${core}/standard_atmosphere.cpp ${core}/validate.cpp
          ${PROJECT_SOURCE_DIR}/src/engine/kernel_lookup.cpp ${PROJECT_BINARY_DIR}/generated/kernel_index.cpp
          ${PROJECT_SOURCE_DIR}/src/model/find_adapter.cpp ${PROJECT_SOURCE_DIR}/src/model/parameters.cpp
          ${PROJECT_SOURCE_DIR}/src/sky/camera.cpp)
