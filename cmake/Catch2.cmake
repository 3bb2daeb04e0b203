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

# Tests and exercises: one precompiled header.
add_library(tests_with_catch2 INTERFACE)
target_include_directories(tests_with_catch2 INTERFACE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(tests_with_catch2 INTERFACE signorini::signorini signorini_light Catch2::Catch2WithMain)
if(SIGNORINI_PRECOMPILE)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/checks_headers.cpp CONTENT "// only its precompiled header is used\n")
  add_library(checks_headers OBJECT ${PROJECT_BINARY_DIR}/checks_headers.cpp)
  target_link_libraries(checks_headers PRIVATE tests_with_catch2 signorini_warnings)
  target_precompile_headers(checks_headers PRIVATE ${PROJECT_SOURCE_DIR}/tests/catch_compat.hpp ${common_headers})
endif()

function(signorini_checks target)  # the flags and headers of a target that holds tests or answers
  target_link_libraries(${target} PRIVATE tests_with_catch2 signorini_warnings)
  if(SIGNORINI_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM checks_headers)
  endif()
endfunction()

# The problems that tests of many rooms solve, compiled once.
file(GLOB test_problems CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/support/problems/*.cpp)
add_library(test_problems STATIC EXCLUDE_FROM_ALL ${test_problems})
set_target_properties(test_problems PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
signorini_checks(test_problems)
