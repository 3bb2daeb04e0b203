# Files that are compiled as one: what they all include is read once.

# The rooms of the library, at most ten files at a time.  The table of a family stays alone, because a program may be linked with
# one of its own; and so do the factorisations of Eigen, which take longest.
function(signorini_rooms_in_batches)
  foreach(source IN LISTS ARGN)
    if(source MATCHES "/(elements|gap_operators|solver_table|effects|backends|backend|core/dense[a-z_]*)\\.cpp$")
      continue()
    endif()
    get_filename_component(room ${source} DIRECTORY)
    get_filename_component(room ${room} NAME)
    math(EXPR batch "0${files_of_${room}} / 10")
    math(EXPR files_of_${room} "0${files_of_${room}} + 1")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${room}_${batch})
  endforeach()
endfunction()

# Sources, `size` at a time, each in a namespace of its own: file names of what is compiled instead.
find_package(Perl REQUIRED)
function(signorini_in_batches batches name size)
  set(result "")
  set(number 0)
  while(ARGN)
    list(SUBLIST ARGN 0 ${size} files)
    list(REMOVE_ITEM ARGN ${files})
    math(EXPR number "${number} + 1")
    set(batch ${PROJECT_BINARY_DIR}/batches/${name}_${number}.cpp)
    add_custom_command(OUTPUT ${batch} DEPENDS ${files} ${PROJECT_SOURCE_DIR}/tools/batch.pl VERBATIM
      COMMAND ${PERL_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/batch.pl ${batch} ${files})
    list(APPEND result ${batch})
  endwhile()
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/batches)
  set(${batches} ${result} PARENT_SCOPE)
endfunction()
