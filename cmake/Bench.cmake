# Measurements: `price` needs nothing, `peers` compares with what is installed of other people's solvers.
file(GLOB peer_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/peers/*.cpp)
set(yardstick_sources bench/rounds.cpp bench/yardsticks.cpp bench/mumps.cpp)
add_executable(price bench/price.cpp ${yardstick_sources})
add_executable(peers bench/peers.cpp ${peer_sources} ${yardstick_sources})
foreach(program price peers)
  target_link_libraries(${program} PRIVATE signorini::signorini signorini_warnings)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${program} PRIVATE SIGNORINI_BENCH_OUT="${PROJECT_BINARY_DIR}/out/bench")
  target_link_libraries(${program} PRIVATE ${CMAKE_DL_LIBS})
endforeach()
target_compile_definitions(peers PRIVATE
  SIGNORINI_PEERS_SCRIPT="${PROJECT_SOURCE_DIR}/bench/peers/peers.py"
  SIGNORINI_GETFEM_SCRIPT="${PROJECT_SOURCE_DIR}/bench/peers/getfem_hertz.py"
  SIGNORINI_PROGRAM="$<TARGET_FILE:signorini_command>")
add_dependencies(peers signorini_command)

# Two of the yardsticks; without them the others remain. MUMPS for one process is opened at run time: its message
# passing has the names of the real one.
find_path(CHOLMOD_HEADERS cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_HEADERS CHOLMOD_LIBRARY)
if(CHOLMOD_HEADERS AND CHOLMOD_LIBRARY)
  foreach(program price peers)
    target_include_directories(${program} SYSTEM PRIVATE ${CHOLMOD_HEADERS})
    target_link_libraries(${program} PRIVATE ${CHOLMOD_LIBRARY})
    target_compile_definitions(${program} PRIVATE SIGNORINI_CHOLMOD)
  endforeach()
endif()
find_path(MUMPS_HEADERS dmumps_c.h)
find_library(MUMPS_SEQ_LIBRARY NAMES dmumps_seq dmumps_seq-5.7 dmumps_seq-5.6 dmumps_seq-5.5 dmumps_seq-5.4)
mark_as_advanced(MUMPS_HEADERS MUMPS_SEQ_LIBRARY)
if(MUMPS_HEADERS AND MUMPS_SEQ_LIBRARY)
  foreach(program price peers)
    target_include_directories(${program} SYSTEM PRIVATE ${MUMPS_HEADERS})
    target_compile_definitions(${program} PRIVATE SIGNORINI_MUMPS_SEQ="${MUMPS_SEQ_LIBRARY}")
  endforeach()
endif()

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
  foreach(program price peers)
    add_test(NAME bench/${program} COMMAND ${program} --out ${PROJECT_BINARY_DIR}/tests/bench/${program})
    set_tests_properties(bench/${program} PROPERTIES LABELS bench)
  endforeach()
endif()
