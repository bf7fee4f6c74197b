# Installs BUILD into PREFIX, emptied first, and checks that what people are promised lies there.
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
foreach(promised include/airlight/sky.h share/airlight/kernels/core/math.glsl share/airlight/data/solar_irradiance.csv)
  if(NOT EXISTS ${PREFIX}/${promised})
    message(FATAL_ERROR "the installation lacks ${promised}")
  endif()
endforeach()
