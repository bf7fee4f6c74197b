# Lines of `probe --batch` and `eval`.
set(commands ${PROJECT_SOURCE_DIR}/apps/cli)
airlight_add_fuzz_test(jsonl
  SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/fuzz_jsonl.cpp
          ${commands}/batch_request.cpp ${commands}/eval_request.cpp ${commands}/json_line.cpp ${commands}/number.cpp
          ${commands}/question.cpp
          ${PROJECT_SOURCE_DIR}/src/engine/kernel_lookup.cpp ${PROJECT_BINARY_DIR}/generated/kernel_index.cpp
          ${PROJECT_SOURCE_DIR}/src/sky/camera.cpp
  OPTIONS -DFMT_HEADER_ONLY -I${commands} -I${PROJECT_SOURCE_DIR}/kernels
  DEPENDS airlight_kernel_index
  DICTIONARY ${CMAKE_CURRENT_SOURCE_DIR}/jsonl.dict
  CORPUS ${CMAKE_CURRENT_SOURCE_DIR}/jsonl)
