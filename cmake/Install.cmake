# cmake --install: library, program, headers, and the files that make find_package(signorini CONFIG) work.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/signorini)
list(TRANSFORM signorini_folders PREPEND signorini_ OUTPUT_VARIABLE libraries)
install(TARGETS signorini ${libraries} EXPORT signoriniTargets)
install(TARGETS signorini_command)
if(TARGET signorini_backends)
  install(TARGETS signorini_backends)
endif()
install(FILES ${PROJECT_BINARY_DIR}/signorini.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
foreach(folder signorini meshes closed_form papers addons)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${folder} DESTINATION include/signorini FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(EXPORT signoriniTargets NAMESPACE signorini:: DESTINATION ${package_dir})
file(WRITE ${PROJECT_BINARY_DIR}/signoriniConfig.cmake
"include(CMakeFindDependencyMacro)
find_dependency(Eigen3 CONFIG)
include(\${CMAKE_CURRENT_LIST_DIR}/signoriniTargets.cmake)
")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/signoriniConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/signoriniConfig.cmake ${PROJECT_BINARY_DIR}/signoriniConfigVersion.cmake
        DESTINATION ${package_dir})
