# The file signorini.pc for those who use the library without CMake, documents and examples, and the package for Debian that `make package`
# builds of all of it: cmake --build build --target signorini_command, then cpack --config build/CPackConfig.cmake.

# A library stands before those that it uses: the plan from its end.  What registers itself must be asked for, see registered.cpp.
set(linked ${libraries})
list(REVERSE linked)
list(TRANSFORM linked PREPEND "-l")
list(JOIN linked " " linked)
list(JOIN signorini_registered " " registered)
set(pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH to_prefix /prefix/${pc_dir} /prefix)
string(REGEX REPLACE "/$" "" to_prefix ${to_prefix})
set(native "")
if(SIGNORINI_NATIVE)
  set(native " -march=native")
endif()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/signorini.pc @ONLY CONTENT
"prefix=\${pcfiledir}/@to_prefix@
includedir=\${prefix}/include/signorini
libdir=\${prefix}/@CMAKE_INSTALL_LIBDIR@

Name: signorini
Description: contact problems in the plane, solved and certified; C++17
Version: @PROJECT_VERSION@
Requires: eigen3 >= 3.4
Cflags: -I\${includedir} -ffp-contract=off@native@
Libs: -L\${libdir} @registered@ @linked@ -pthread
")
install(FILES ${PROJECT_BINARY_DIR}/signorini.pc DESTINATION ${pc_dir})

# Examples are scenes to start from; those of other projects and their results stay in the sources.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
        PATTERN decks EXCLUDE PATTERN results EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/docs/signorini.schema.json ${PROJECT_SOURCE_DIR}/tools/med2inp.py DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/book/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/book COMPONENT book EXCLUDE_FROM_ALL OPTIONAL)

# One package: everything but the program with other back ends, which would have everybody install MPI.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME signorini)
set(CPACK_PACKAGE_CONTACT "The Signorini authors <authors@signorini.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "contact problems in the plane, solved and certified")
set(CPACK_PACKAGE_DESCRIPTION "Reads scenes of elastic bodies that touch, with friction, load steps and
large sliding, solves them, and certifies the answer against the data.
Also solves complementarity problems and quadratic programmes. With the C++
library, its headers, the examples and the book, if it was made.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/package)
set(CPACK_COMPONENTS_ALL Unspecified book)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, libeigen3-dev (>= 3.4), pkg-config")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-meshio, paraview")
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
include(CPack)
