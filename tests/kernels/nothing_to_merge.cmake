# No kernel object may hold a symbol that the linker could hand to another instruction set (weak, unique), or code that runs before one
# is chosen (static initialisers).
foreach(object ${OBJECTS})
  execute_process(COMMAND ${NM} -C ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]* ([WwVvu] [^\n]*|[tT] _GLOBAL__sub_I[^\n]*)" bad "${symbols}")
  # Names of other objects' weak symbols have no address; those may stand.
  list(FILTER bad INCLUDE REGEX "^[0-9a-f]")
  if(bad)
    string(REPLACE ";" "\n  " bad "${bad}")
    message(SEND_ERROR "${object}:\n  ${bad}")
  endif()
endforeach()
list(LENGTH OBJECTS count)
message("${count} kernel objects")
