# Included by project(): from here on find_package() refuses everything but what the core library may use.
macro(find_package name)
  if(NOT "${name}" MATCHES "^(xsimd|TBB|Threads|Python3)$")
    message(FATAL_ERROR "the core library asks for ${name}; it may need xsimd and TBB only")
  endif()
  _find_package(${ARGV})
endmacro()
