# The live figures, chapters/chNN_topic/live/*.cpp, for this machine: the program `live` answers in a terminal what
# pages answer in a browser, and tests ask it.  cmake/engine/CMakeLists.txt compiles the same for browsers.
file(GLOB live_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/live/figure*.cpp
     ${PROJECT_SOURCE_DIR}/chapters/ch[0-9][0-9]_*/live/*.cpp)
add_library(live_figures STATIC EXCLUDE_FROM_ALL ${live_sources})
set_target_properties(live_figures PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 5)
target_include_directories(live_figures PUBLIC ${PROJECT_SOURCE_DIR}/src PRIVATE ${PROJECT_SOURCE_DIR}/tests)
include(cmake/Exhibits.cmake)
signorini_exhibits(${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_include_directories(live_figures PRIVATE ${PROJECT_BINARY_DIR}/generated)
target_link_libraries(live_figures PUBLIC signorini::signorini PRIVATE signorini_warnings)
signorini_precompiled(live_figures)
add_executable(live EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/src/live/native.cpp)
target_link_libraries(live PRIVATE live_figures signorini_warnings)
