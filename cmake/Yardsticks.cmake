# Plain solves by other people's factors, for `price` and for the chapter program that includes bench/yardsticks.hpp.
include_guard()
add_library(yardsticks STATIC EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/bench/yardsticks.cpp)
target_include_directories(yardsticks PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(yardsticks PUBLIC signorini::signorini PRIVATE signorini_warnings)

# Without CHOLMOD the others remain.
if(found_CHOLMOD)
  target_include_directories(yardsticks SYSTEM PRIVATE ${CHOLMOD_HEADERS})
  target_link_libraries(yardsticks PRIVATE ${CHOLMOD_LIBRARY})
  target_compile_definitions(yardsticks PRIVATE SIGNORINI_CHOLMOD)
endif()
