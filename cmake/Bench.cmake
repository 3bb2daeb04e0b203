# Measurements: `price`, `effectivity`, `accuracy`, `round_bodies` and `many_bodies` need nothing, `peers` compares with what is installed of other people's solvers.
file(GLOB peer_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/peers/*.cpp)
add_executable(price bench/price.cpp bench/rounds.cpp)
add_executable(peers bench/peers.cpp bench/rounds.cpp ${peer_sources})
add_executable(effectivity bench/effectivity.cpp)
add_executable(accuracy bench/accuracy.cpp)
add_executable(round_bodies bench/round_bodies.cpp)
add_executable(many_bodies bench/many_bodies.cpp)
include(cmake/Yardsticks.cmake)
foreach(program price peers)
  target_link_libraries(${program} PRIVATE yardsticks)
endforeach()
foreach(program price peers effectivity accuracy round_bodies many_bodies)
  target_link_libraries(${program} PRIVATE signorini::signorini signorini_warnings)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${program} PRIVATE SIGNORINI_BENCH_OUT="${PROJECT_BINARY_DIR}/out/bench")
endforeach()
target_link_libraries(peers PRIVATE ${CMAKE_DL_LIBS})
target_compile_definitions(peers PRIVATE
  SIGNORINI_PEERS_SCRIPT="${PROJECT_SOURCE_DIR}/bench/peers/peers.py"
  SIGNORINI_GETFEM_SCRIPT="${PROJECT_SOURCE_DIR}/bench/peers/getfem_hertz.py"
  SIGNORINI_PROGRAM="$<TARGET_FILE:signorini_command>")
add_dependencies(peers signorini_command)

# Its headers include each other from both folders.
find_path(SICONOS_CONFIG SiconosConfig.h PATH_SUFFIXES siconos)
find_path(SICONOS_NUMERICS LCP_Solvers.h PATH_SUFFIXES siconos/numerics)
find_library(SICONOS_LIBRARY siconos_numerics)
mark_as_advanced(SICONOS_CONFIG SICONOS_NUMERICS SICONOS_LIBRARY)
if(SICONOS_CONFIG AND SICONOS_NUMERICS AND SICONOS_LIBRARY)
  target_include_directories(peers SYSTEM PRIVATE ${SICONOS_CONFIG} ${SICONOS_NUMERICS})
  target_link_libraries(peers PRIVATE ${SICONOS_LIBRARY})
  target_compile_definitions(peers PRIVATE SIGNORINI_SICONOS)
endif()

if(SIGNORINI_BUILD_TESTS)  # on small problems: they end with 0 only if all is certified and equal to what it must equal
  foreach(program price peers effectivity accuracy round_bodies many_bodies)
    add_test(NAME bench/${program} COMMAND ${program} --out ${PROJECT_BINARY_DIR}/tests/bench/${program})
    set_tests_properties(bench/${program} PROPERTIES LABELS bench)
  endforeach()
endif()
