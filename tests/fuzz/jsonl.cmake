# Lines of `probe --batch` and `eval`.
add_executable(fuzz_jsonl fuzz_jsonl.cpp)
target_link_libraries(fuzz_jsonl PRIVATE airlight_commands)
target_compile_options(fuzz_jsonl PRIVATE -fsanitize=fuzzer,address,undefined)
target_link_options(fuzz_jsonl PRIVATE -fsanitize=fuzzer,address,undefined)
