# Every chapters/chNN_topic/exercises/exK_topic is exercise N.K, proven from both ends:
#   exN.K/solution, exN.K/solution-heldout   the reference solution passes both test files
#   exN.K/starter                            attempt.cpp compiles with both and fails a check of the first
# All of them are two programs, exercise_solutions and exercise_starters, whose tests begin with the name of the exercise.
# Your own answer is compiled and checked alone, by `make exN.K` (tools/exercise.sh).  Since it stands in attempt.cpp, a right one fails
# exN.K/starter, and one that does not compile stops `make`, with a message that names its file; names may be the same in several answers.
# For those who collect answers the same are tests:
#   exN.K/answer, then exN.K/answer-heldout  the held-out tests open when the first ones pass
# They exist only for `ctest -C answer`.
# Exercises whose test.cpp includes support/problem_classes.hpp, for answers that are solvers, are linked with it.
# A hand-out has neither solutions nor held-out tests: there only exN.K/answer is left.
set(exercises_from ${PROJECT_SOURCE_DIR}/chapters/ch[0-9][0-9]_*/exercises/ex*)
file(GLOB exercise_headers CONFIGURE_DEPENDS ${exercises_from}/exercise.hpp)
file(GLOB exercise_heldout CONFIGURE_DEPENDS ${exercises_from}/test_heldout.cpp)
file(GLOB exercise_solutions CONFIGURE_DEPENDS ${exercises_from}/solution.cpp)
set(exercises_proven "")  # folders of those that have both

# What their tests found is told to tools/judge.pl.
add_library(exercise_judge OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tests/tools/judged.cpp)
target_link_libraries(exercise_judge PRIVATE tests_with_catch2 signorini_warnings)

function(signorini_exercise_part target source)  # one source file, compiled once
  add_library(${target} OBJECT EXCLUDE_FROM_ALL ${source})
  signorini_checks(${target})
endfunction()

function(signorini_exercise_program target)  # the parts in ARGN, linked
  add_executable(${target} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:exercise_judge>)
  foreach(part IN LISTS ARGN)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${part}>)
  endforeach()
  target_link_libraries(${target} PRIVATE signorini::signorini Catch2::Catch2WithMain)
endfunction()

# What is linked without CMake: behind an answer, by tools/grade.pl and tests/exercises/submissions.pl.
list(TRANSFORM signorini_folders PREPEND signorini_ OUTPUT_VARIABLE exercise_libraries)
list(APPEND exercise_libraries Catch2::Catch2WithMain)
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
  list(APPEND exercise_libraries Catch2::Catch2)
endif()
function(signorini_linked out)  # targets in ARGN, as words for the linker
  list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE files)
  list(JOIN signorini_registered " " registered)
  list(JOIN files " " files)
  set(${out} "${registered} -Wl,--start-group ${files} -Wl,--end-group -pthread" PARENT_SCOPE)
endfunction()

function(signorini_exercise dir)
  if(NOT dir MATCHES "/ch([0-9]+)_[^/]*/exercises/ex([0-9]+)_[^/]*$")
    message(FATAL_ERROR "${dir}: an exercise lies in chapters/chNN_topic/exercises/exK_topic")
  endif()
  math(EXPR chapter "${CMAKE_MATCH_1}")
  set(ex ex${chapter}.${CMAKE_MATCH_2})
  set(heldout ${dir}/test_heldout.cpp)
  set(solution ${dir}/solution.cpp)

  signorini_exercise_part(${ex}_test ${dir}/test.cpp)
  signorini_exercise_part(${ex}_attempt ${dir}/attempt.cpp)
  # An answer has the headers that it includes and no others, whether or not this build precompiles some.
  set_target_properties(${ex}_attempt PROPERTIES DISABLE_PRECOMPILE_HEADERS ON)
  signorini_exercise_program(${ex}.answer ${ex}_test ${ex}_attempt)
  add_custom_target(${ex} DEPENDS ${ex}.answer)
  add_test(NAME ${ex}/answer COMMAND ${ex}.answer CONFIGURATIONS answer)
  set_tests_properties(${ex}/answer PROPERTIES FIXTURES_SETUP ${ex} LABELS answer TIMEOUT 120)
  if(EXISTS ${heldout})
    signorini_exercise_part(${ex}_heldout ${heldout})
    signorini_exercise_program(${ex}.answer-heldout ${ex}_heldout ${ex}_attempt)
    add_dependencies(${ex} ${ex}.answer-heldout)
    add_test(NAME ${ex}/answer-heldout COMMAND ${ex}.answer-heldout CONFIGURATIONS answer)
    set_tests_properties(${ex}/answer-heldout PROPERTIES FIXTURES_REQUIRED ${ex} LABELS answer TIMEOUT 120)
  endif()

  if(EXISTS ${solution} AND EXISTS ${heldout})
    signorini_exercise_part(${ex}_solution ${solution})
    signorini_exercise_program(${ex}.solution ${ex}_test ${ex}_solution)
    signorini_exercise_program(${ex}.solution-heldout ${ex}_heldout ${ex}_solution)
    add_test(NAME ${ex}/solution COMMAND exercise_solutions "${ex} *" "~${ex} held out*" ${some_tests})
    add_test(NAME ${ex}/solution-heldout COMMAND exercise_solutions "${ex} held out*" ${some_tests})
    set_tests_properties(${ex}/solution ${ex}/solution-heldout PROPERTIES LABELS exercise TIMEOUT 300)
    add_test(NAME ${ex}/starter COMMAND perl ${PROJECT_SOURCE_DIR}/tools/judge.pl starter $<TARGET_FILE:exercise_starters>
             "${ex} *" "~${ex} held out*")
    set_tests_properties(${ex}/starter PROPERTIES LABELS "exercise;starter" TIMEOUT 120)
    set(exercises_proven ${exercises_proven} ${dir} PARENT_SCOPE)
  endif()

  set(libraries ${exercise_libraries})
  file(STRINGS ${dir}/test.cpp asks REGEX "support/problem_classes\\.hpp")
  foreach(program ${ex}.answer ${ex}.answer-heldout ${ex}.solution ${ex}.solution-heldout)
    if(asks AND TARGET ${program})
      target_link_libraries(${program} PRIVATE problem_classes)
    endif()
  endforeach()
  if(asks)
    list(PREPEND libraries problem_classes test_problems)
  endif()
  if(TARGET ${ex}.solution)  # what tools/grade.pl puts around an answer
    signorini_linked(libraries ${libraries})
    file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/grade/parts/${ex} CONTENT
"folder ${dir}
link ${CMAKE_CXX_COMPILER} ${CMAKE_CXX_FLAGS} ${CMAKE_EXE_LINKER_FLAGS}
judge $<TARGET_OBJECTS:exercise_judge>
tests $<TARGET_OBJECTS:${ex}_test>
heldout $<TARGET_OBJECTS:${ex}_heldout>
libraries ${libraries}
")
  endif()
endfunction()

# Without a test of the name Catch2 3 fails by itself.
set(some_tests "")
if(Catch2_VERSION VERSION_LESS 3)
  set(some_tests -w NoTests)
endif()
foreach(header IN LISTS exercise_headers)
  get_filename_component(dir ${header} DIRECTORY)
  signorini_exercise(${dir})
endforeach()
if(exercises_proven)
  add_custom_target(exercises ALL)
  list(TRANSFORM exercises_proven REPLACE "(.+)" "\\1/test.cpp;\\1/test_heldout.cpp" OUTPUT_VARIABLE exercise_tests)
  list(TRANSFORM exercises_proven APPEND "/solution.cpp" OUTPUT_VARIABLE solutions)
  list(TRANSFORM exercises_proven APPEND "/attempt.cpp" OUTPUT_VARIABLE attempts)
  signorini_in_batches(batches exercise_tests 16 ${exercise_tests})
  add_library(all_exercise_tests OBJECT ${batches})
  signorini_checks(all_exercise_tests)
  # Both tests of an exercise without those of others, as `make exN.K` compiles them, but for the code.
  signorini_in_batches(pairs exercise_alone 2 ${exercise_tests})
  add_library(exercises_alone OBJECT EXCLUDE_FROM_ALL ${pairs})
  signorini_checks(exercises_alone)
  target_compile_options(exercises_alone PRIVATE -fsyntax-only)
  if(TARGET alone)
    add_dependencies(alone exercises_alone)
  endif()
  add_executable(exercise_solutions ${solutions})
  set_target_properties(exercise_solutions PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  add_executable(exercise_starters ${attempts})
  foreach(program exercise_solutions exercise_starters)
    target_sources(${program} PRIVATE $<TARGET_OBJECTS:exercise_judge> $<TARGET_OBJECTS:all_exercise_tests>)
    signorini_checks(${program})
    target_link_libraries(${program} PRIVATE problem_classes)
    add_dependencies(exercises ${program})
  endforeach()
  signorini_linked(libraries problem_classes test_problems ${exercise_libraries})
  set(objects $<TARGET_OBJECTS:exercise_judge> $<TARGET_OBJECTS:all_exercise_tests> $<TARGET_OBJECTS:exercise_solutions>)
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/submissions CONTENT
       "${CMAKE_CXX_COMPILER} ${CMAKE_CXX_FLAGS} ${CMAKE_EXE_LINKER_FLAGS} $<JOIN:${objects}, > ${libraries}")
endif()
