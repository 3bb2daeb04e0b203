# The programs of a chapter, chapters/chNN_topic/*.cpp, become one: build/bin/chNN runs them one after the other, topic.cpp first,
# `chNN NAME` the one of NAME.cpp, which writes chNN_NAME.results into the same folder.  They are compiled as one file, see
# tools/batch.pl; and these tests:
#   chNN/run      the programs solve their problems and write into build/out/chNN
#   chNN/results  what they wrote agrees with the committed numbers, tables and curves
#   chNN/figures  gnuplot draws every figure from the fresh curves without a warning, and the committed
#                 pictures were drawn from the committed curves
#   chNN/text     the text quotes the committed numbers, tables and code
# `ctest -R ch06/` runs one chapter.  The target `chapters` compiles all of them and nothing else, `alone` lets the compiler
# read each program, and each public header, as the file that it is, without writing code.
find_program(GNUPLOT gnuplot)
add_custom_target(chapters)
add_custom_target(alone)  # programs one by one and the tests of exercises apart: none may live on what another one of its batch includes
add_dependencies(alone headers_alone)
add_custom_target(run_chapters)  # all but the first; one runs while the next is compiled

file(GLOB folders LIST_DIRECTORIES true CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/ch[0-9][0-9]_*)
set(chapter_names "")
foreach(dir IN LISTS folders)
  get_filename_component(dir_name ${dir} NAME)
  string(SUBSTRING ${dir_name} 0 4 name)
  string(SUBSTRING ${dir_name} 5 -1 topic)
  file(GLOB programs CONFIGURE_DEPENDS ${dir}/*.cpp)
  if(NOT programs)
    continue()
  endif()
  if(NOT EXISTS ${dir}/${topic}.cpp)
    message(FATAL_ERROR "${dir}: the first program of ${dir_name} is called ${topic}.cpp")
  endif()
  list(REMOVE_ITEM programs ${dir}/${topic}.cpp)
  list(PREPEND programs ${dir}/${topic}.cpp)
  set(out ${PROJECT_BINARY_DIR}/out/${name})
  set(batch ${PROJECT_BINARY_DIR}/batches/${name}.cpp)
  signorini_batch(${batch} "${programs}" --main ${name})
  # Only linking needs the library.  With OPTIMIZE_DEPENDENCIES the chapters compile while the library does.
  add_library(${name}_programs OBJECT ${batch})
  set_target_properties(${name}_programs PROPERTIES OPTIMIZE_DEPENDENCIES ON)
  add_executable(${name} $<TARGET_OBJECTS:${name}_programs>)
  # What its files include says which parts of the library it is linked with.  So a chapter has the effects and the factor of an
  # add-on if one of its files includes a header of it, see registered.cpp there; without, K is factored by Eigen.
  file(GLOB files CONFIGURE_DEPENDS ${dir}/*.cpp ${dir}/*.hpp)
  signorini_parts_of(library ${files})
  foreach(program IN LISTS programs)
    file(STRINGS ${program} asks REGEX "bench/yardsticks\\.hpp")
    if(asks)
      include(cmake/Yardsticks.cmake)
      set(library yardsticks ${library})
    endif()
  endforeach()
  target_link_libraries(${name} PRIVATE ${library})
  add_library(${name}_alone OBJECT EXCLUDE_FROM_ALL ${programs})
  foreach(target ${name}_programs ${name}_alone)
    target_link_libraries(${target} PRIVATE ${library} signorini_warnings)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/tests)  # for scenes that tests share
    target_compile_definitions(${target} PRIVATE SIGNORINI_CHAPTER_OUT="${out}" SIGNORINI_CHAPTER_DATA="${dir}")
  endforeach()
  target_link_libraries(${name}_programs PRIVATE signorini_light)
  target_compile_options(${name}_alone PRIVATE -fsyntax-only)
  signorini_precompiled(${name}_alone)
  add_dependencies(alone ${name}_alone)
  add_dependencies(chapters ${name})
  add_custom_target(run_${name} COMMAND ${tools}/chapter.sh show $<TARGET_FILE:${name}> ${out} ${dir} VERBATIM)
  if(chapter_names)  # the first has run before
    add_dependencies(run_chapters run_${name})
  endif()
  list(APPEND chapter_names ${name})

  # What takes long is a test of its own, `ctest -C long -L long`: chNN/run leaves it out and takes its committed results.
  execute_process(COMMAND ${PERL_EXECUTABLE} ${tools}/batch.pl --long ${programs} OUTPUT_VARIABLE long COMMAND_ERROR_IS_FATAL ANY)
  if(long)
    add_test(NAME ${name}/long COMMAND sh -c "'${tools}/chapter.sh' run '$<TARGET_FILE:${name}>' '${out}_long' && \
      '${PERL_EXECUTABLE}' '${tools}/compare.pl' '${dir}' '${out}_long'" CONFIGURATIONS long)
    set_tests_properties(${name}/long PROPERTIES LABELS "chapter;long" TIMEOUT 600)
  endif()
  add_test(NAME ${name}/run COMMAND ${tools}/chapter.sh run $<TARGET_FILE:${name}> ${out} ${dir})
  set_tests_properties(${name}/run PROPERTIES FIXTURES_SETUP ${name} LABELS chapter TIMEOUT 600)
  add_test(NAME ${name}/results COMMAND ${PERL_EXECUTABLE} ${tools}/compare.pl ${dir} ${out})
  set_tests_properties(${name}/results PROPERTIES FIXTURES_REQUIRED ${name} LABELS chapter)
  if(GNUPLOT)
    add_test(NAME ${name}/figures COMMAND ${tools}/chapter.sh figures ${dir} ${out})
    set_tests_properties(${name}/figures PROPERTIES FIXTURES_REQUIRED ${name} LABELS "chapter;figure")
  endif()
endforeach()
if(NOT GNUPLOT)
  signorini_left_out("chNN/figures" "no gnuplot: tools/setup.sh build")
endif()

file(GLOB texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/ch[0-9][0-9]_*/README.md)
foreach(text IN LISTS texts)
  get_filename_component(dir ${text} DIRECTORY)
  get_filename_component(dir_name ${dir} NAME)
  string(SUBSTRING ${dir_name} 0 4 name)
  add_test(NAME ${name}/text COMMAND ${PERL_EXECUTABLE} ${tools}/weave.pl --check ${text})
  set_tests_properties(${name}/text PROPERTIES LABELS docs)
endforeach()
