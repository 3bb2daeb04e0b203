# Plain solves by other people's factors, for `price`, `peers` and the chapter program that includes bench/yardsticks.hpp.
include_guard()
include(cmake/Factors.cmake)
add_library(yardsticks STATIC EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/bench/yardsticks.cpp ${PROJECT_SOURCE_DIR}/bench/mumps.cpp)
target_include_directories(yardsticks PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(yardsticks PUBLIC signorini::signorini PRIVATE signorini_warnings ${CMAKE_DL_LIBS})

# Without CHOLMOD the others remain.
if(CHOLMOD_HEADERS AND CHOLMOD_LIBRARY)
  target_include_directories(yardsticks SYSTEM PRIVATE ${CHOLMOD_HEADERS})
  target_link_libraries(yardsticks PRIVATE ${CHOLMOD_LIBRARY})
  target_compile_definitions(yardsticks PRIVATE SIGNORINI_CHOLMOD)
endif()

# MUMPS for one process; its message passing has the names of the real one, so nothing else here may use MPI.
find_library(MUMPS_SEQ_LIBRARY NAMES dmumps_seq dmumps_seq-5.7 dmumps_seq-5.6 dmumps_seq-5.5 dmumps_seq-5.4)
mark_as_advanced(MUMPS_SEQ_LIBRARY)
if(MUMPS_HEADERS AND MUMPS_SEQ_LIBRARY)
  target_include_directories(yardsticks SYSTEM PRIVATE ${MUMPS_HEADERS})
  target_link_libraries(yardsticks PRIVATE ${MUMPS_SEQ_LIBRARY})
  target_compile_definitions(yardsticks PRIVATE SIGNORINI_MUMPS_SEQ)
endif()
