# Every chapters/chNN_topic with a topic.cpp becomes the program chNN, and these tests:
#   chNN/run      the program solves its problem and writes into build/out/chNN
#   chNN/results  what it wrote agrees with the committed numbers, tables and curves
#   chNN/figures  gnuplot draws every figure from the fresh curves without a warning, and the committed
#                 pictures were drawn from the committed curves
#   chNN/text     the text quotes the committed numbers, tables and code
# `ctest -R ch06/` runs one chapter.  The target `chapters` compiles all of them and nothing else.
find_package(Perl REQUIRED)
find_program(GNUPLOT gnuplot)
set(tools ${PROJECT_SOURCE_DIR}/tools)
add_custom_target(chapters)

file(GLOB texts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/ch[0-9][0-9]_*/README.md)
file(GLOB programs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/chapters/ch[0-9][0-9]_*/*.cpp)
file(GLOB scripts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/figures/*.gp)
set(chapter_names "")
foreach(program IN LISTS programs)
  get_filename_component(dir ${program} DIRECTORY)
  get_filename_component(dir_name ${dir} NAME)
  string(SUBSTRING ${dir_name} 0 4 name)
  string(SUBSTRING ${dir_name} 5 -1 topic)
  if(NOT program STREQUAL ${dir}/${topic}.cpp)
    message(FATAL_ERROR "${program}: the program of ${dir_name} is called ${topic}.cpp")
  endif()
  list(APPEND chapter_names ${name})
  set(out ${PROJECT_BINARY_DIR}/out/${name})

  add_executable(${name} ${program})
  target_link_libraries(${name} PRIVATE signorini::signorini signorini_warnings)
  target_compile_definitions(${name} PRIVATE SIGNORINI_CHAPTER_OUT="${out}" SIGNORINI_CHAPTER_DATA="${dir}")
  signorini_precompiled(${name})
  add_dependencies(chapters ${name})

  add_test(NAME ${name}/run COMMAND ${tools}/chapter.sh run $<TARGET_FILE:${name}> ${out})
  set_tests_properties(${name}/run PROPERTIES FIXTURES_SETUP ${name} LABELS chapter TIMEOUT 600)
  add_test(NAME ${name}/results COMMAND ${PERL_EXECUTABLE} ${tools}/compare.pl ${dir} ${out})
  set_tests_properties(${name}/results PROPERTIES FIXTURES_REQUIRED ${name} LABELS chapter)
  if(GNUPLOT)
    add_test(NAME ${name}/figures COMMAND ${tools}/chapter.sh figures ${dir} ${out})
    set_tests_properties(${name}/figures PROPERTIES FIXTURES_REQUIRED ${name} LABELS "chapter;figure")
  endif()
endforeach()

foreach(text IN LISTS texts)
  get_filename_component(dir ${text} DIRECTORY)
  get_filename_component(dir_name ${dir} NAME)
  string(SUBSTRING ${dir_name} 0 4 name)
  add_test(NAME ${name}/text COMMAND ${PERL_EXECUTABLE} ${tools}/weave.pl --check ${text})
  set_tests_properties(${name}/text PROPERTIES LABELS docs)
endforeach()
