# The texts of the museum, tests/hard, as a header for programs that read no files: live/exhibits.hpp in `folder`.
function(signorini_exhibits root folder)
  file(GLOB texts CONFIGURE_DEPENDS RELATIVE ${root}/tests/hard ${root}/tests/hard/*/*.t*)
  set(lines "")
  foreach(name IN LISTS texts)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/tests/hard/${name})
    file(READ ${root}/tests/hard/${name} text)
    string(APPEND lines "{\"${name}\", R\"~~(${text})~~\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/live/exhibits.hpp @ONLY CONTENT
"// tests/hard, the path and the text of each exhibit
#pragma once
namespace live {
struct ExhibitText {
  const char* file;
  const char* content;
};
constexpr ExhibitText exhibits[] = {
@lines@};
}  // namespace live
")
endfunction()
