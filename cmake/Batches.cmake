# Files that are compiled as one: what they all include is read once.

# The sources of a folder of the library, at most ten files at a time.  These stay alone: the table of a family, because a program may be
# linked with one of its own; registered.cpp, which the linker is asked for by name; backend.cpp, because it is compiled with a definition of its own, cmake/Backends.cmake; and the factorisations
# of Eigen, because they take longest.
function(signorini_unity_batches)
  foreach(source IN LISTS ARGN)
    if(source MATCHES "/(elements|gap_operators|solver_table|effects|backends|backend|registered|core/dense[a-z_]*)\\.cpp$")
      continue()
    endif()
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(folder ${folder} NAME)
    math(EXPR batch "0${n_files} / 10")
    math(EXPR n_files "0${n_files} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${folder}_${batch})
  endforeach()
endfunction()

# `batch`, a file that compiles others as one, each in a namespace of its own: `files`, and in ARGN options of tools/batch.pl.
function(signorini_batch batch files)
  find_package(Perl REQUIRED)
  add_custom_command(OUTPUT ${batch} DEPENDS ${files} ${PROJECT_SOURCE_DIR}/tools/batch.pl VERBATIM
    COMMAND ${PERL_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/batch.pl ${batch} ${ARGN} ${files})
endfunction()

# The sources in ARGN, `size` at a time: into `batches` go the names of what is compiled instead.
function(signorini_in_batches batches name size)
  set(result "")
  set(number 0)
  while(ARGN)
    list(SUBLIST ARGN 0 ${size} files)
    list(REMOVE_ITEM ARGN ${files})
    math(EXPR number "${number} + 1")
    set(batch ${PROJECT_BINARY_DIR}/batches/${name}_${number}.cpp)
    signorini_batch(${batch} "${files}")
    list(APPEND result ${batch})
  endwhile()
  set(${batches} ${result} PARENT_SCOPE)
endfunction()

# The targets of src/plan that files include headers of, or other headers that they name.
function(signorini_parts_of parts)
  set(found "")
  while(ARGN)
    list(POP_FRONT ARGN file)
    file(STRINGS ${file} included REGEX "^#include \"")
    foreach(line IN LISTS included)
      string(REGEX MATCH "\"([a-z_/]*)/[a-z0-9_]+\\.hpp\"" header "${line}")
      get_filename_component(folder "${CMAKE_MATCH_1}" NAME)
      if(TARGET signorini_${folder})
        list(APPEND found signorini_${folder})
      elseif(header MATCHES "^\"(support|reference)/(.*)\"$")
        list(APPEND ARGN ${PROJECT_SOURCE_DIR}/tests/${CMAKE_MATCH_1}/${CMAKE_MATCH_2})
      endif()
    endforeach()
  endwhile()
  list(REMOVE_DUPLICATES found)
  set(${parts} ${found} PARENT_SCOPE)
endfunction()
