# What `cmake --install` lays down: the core library with its headers for find_package(airlight CONFIG), the kernels for
# people who run them in a program of their own, and the data with its origin notes. Applications install themselves.
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS airlight_core EXPORT airlight-targets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/airlight DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/kernels ${PROJECT_SOURCE_DIR}/data DESTINATION ${CMAKE_INSTALL_DATADIR}/airlight)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(airlight_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/airlight)
install(EXPORT airlight-targets NAMESPACE airlight:: DESTINATION ${airlight_package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/airlight-config.cmake.in ${PROJECT_BINARY_DIR}/airlight-config.cmake
  INSTALL_DESTINATION ${airlight_package_dir} PATH_VARS CMAKE_INSTALL_DATADIR)
# Before 1.0 any minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/airlight-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/airlight-config.cmake ${PROJECT_BINARY_DIR}/airlight-config-version.cmake
  DESTINATION ${airlight_package_dir})
