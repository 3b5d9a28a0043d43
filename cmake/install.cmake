# What `cmake --install` and `cpack` deliver: the program, and the libraries for other CMake projects
# (find_package(artcal), docs/library.md). Whatever layers exist are taken from ARTCAL_LAYERS.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY ARTCAL_LAYERS)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/artcal)

# Outside, one writes <artcal/acquisition/arm/forward_kinematics.h>; the headers themselves say "acquisition/arm/arm.h", which
# the header set's own destination serves.
foreach(layer IN LISTS layers)
  target_include_directories(${layer} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
endforeach()
install(TARGETS ${layers}
        EXPORT artcalTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/artcal COMPONENT development)
install(EXPORT artcalTargets NAMESPACE artcal:: DESTINATION ${config_dir} COMPONENT development)
# Who links the layers must find what they link: cmake/dependencies.cmake again, without what only the
# program uses.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake dependencies REGEX "^find_package\\(")
list(FILTER dependencies EXCLUDE REGEX "CLI11|nlohmann_json|TBB")
list(TRANSFORM dependencies REPLACE "^find_package" "find_dependency")
list(TRANSFORM dependencies REPLACE " REQUIRED" "")
list(JOIN dependencies "\n" ARTCAL_FIND_DEPENDENCIES)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/artcalConfig.cmake.in artcalConfig.cmake
                              INSTALL_DESTINATION ${config_dir} NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor release may change the interface.
write_basic_package_version_file(artcalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/artcalConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/artcalConfigVersion.cmake
        DESTINATION ${config_dir} COMPONENT development)

if(TARGET artcal_program)
  install(TARGETS artcal_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  # Manual pages and completion, made by the program itself.
  set(shell_files ${CMAKE_CURRENT_BINARY_DIR}/shell_files)
  add_custom_command(OUTPUT ${shell_files}/artcal.fish
                     COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:artcal_program> -DFOLDER=${shell_files} -P
                             ${CMAKE_CURRENT_LIST_DIR}/shell_files.cmake
                     DEPENDS artcal_program ${CMAKE_CURRENT_LIST_DIR}/shell_files.cmake VERBATIM)
  add_custom_target(artcal_shell_files ALL DEPENDS ${shell_files}/artcal.fish)
  install(DIRECTORY ${shell_files}/man1/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${shell_files}/artcal.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          RENAME artcal COMPONENT program)
  install(FILES ${shell_files}/_artcal DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
  install(FILES ${shell_files}/artcal.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
          COMPONENT program)
endif()
if(EXISTS ${PROJECT_SOURCE_DIR}/examples)
  install(DIRECTORY examples/ DESTINATION ${CMAKE_INSTALL_DATADIR}/artcal/examples COMPONENT program)
endif()

install(FILES README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/artcal COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/artcal COMPONENT program)

set(packages program:artcal development:libartcal-dev)
if(ARTCAL_BUILD_PYTHON)
  list(APPEND packages python:python3-artcal)
endif()
foreach(component_and_package IN LISTS packages)
  string(REPLACE ":" ";" pair ${component_and_package})
  list(GET pair 0 component)
  list(GET pair 1 package)
  set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES LICENSE DESTINATION ${doc_dir} COMPONENT ${component} RENAME copyright)
  install(FILES CHANGELOG.md DESTINATION ${doc_dir} COMPONENT ${component})
endforeach()

include(cmake/licences.cmake)
include(cmake/packages.cmake)
