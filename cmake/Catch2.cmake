# Catch2 2.13 or 3.  Both offer Catch2::Catch2WithMain and catch_discover_tests; a version 2 that was
# packaged without its compiled main gets one here.
find_package(Catch2 CONFIG REQUIRED)
include(Catch)
if(NOT TARGET Catch2::Catch2WithMain)
  set(catch_main ${PROJECT_BINARY_DIR}/catch_main.cpp)
  file(CONFIGURE OUTPUT ${catch_main} CONTENT "#define CATCH_CONFIG_MAIN\n#include <catch2/catch.hpp>\n")
  add_library(catch_main STATIC ${catch_main})
  target_compile_options(catch_main PRIVATE -O0)
  target_link_libraries(catch_main PUBLIC Catch2::Catch2)
  add_library(Catch2::Catch2WithMain ALIAS catch_main)
endif()
