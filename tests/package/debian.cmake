# Builds the Debian packages and looks into them with dpkg-deb.
find_program(dpkg_deb dpkg-deb)
find_program(dpkg_shlibdeps dpkg-shlibdeps)
if(NOT dpkg_deb OR NOT dpkg_shlibdeps)
  message("This test needs dpkg-dev")
  return()
endif()
set(packages ${WORK_DIR}/packages)
file(REMOVE_RECURSE ${packages})
execute_process(COMMAND ${CMAKE_CPACK_COMMAND} --config ${BUILD_DIR}/CPackConfig.cmake -G DEB -B ${packages}
                RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(failed)
  message(FATAL_ERROR "cpack failed:\n${output}")
endif()

function(expect_package name)
  cmake_parse_arguments(EXPECT "" "" "CONTROL;FILES" ${ARGN})
  file(GLOB package ${packages}/${name}_${VERSION}-1_*.deb)
  list(LENGTH package count)
  if(NOT count EQUAL 1)
    message(FATAL_ERROR "Expected one package ${name}, found: ${package}\n${output}")
  endif()
  execute_process(COMMAND ${dpkg_deb} --info ${package} OUTPUT_VARIABLE control COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${dpkg_deb} --contents ${package} OUTPUT_VARIABLE contents COMMAND_ERROR_IS_FATAL ANY)
  foreach(pattern IN LISTS EXPECT_CONTROL)
    if(NOT control MATCHES "${pattern}")
      message(FATAL_ERROR "${name}: \"${pattern}\" is not in its control file:\n${control}")
    endif()
  endforeach()
  foreach(pattern IN LISTS EXPECT_FILES)
    if(NOT contents MATCHES "${pattern}")
      message(FATAL_ERROR "${name}: \"${pattern}\" is not among its files:\n${contents}")
    endif()
  endforeach()
endfunction()

expect_package(libartcal-dev
  CONTROL "Package: libartcal-dev" "Maintainer: artcal maintainers" "Depends: .*libeigen3-dev.*libceres-dev"
  FILES "/usr/include/artcal/acquisition/arm/forward_kinematics\\.h" "/usr/include/artcal/core/error\\.h"
        "/usr/lib/.*libartcal_acquisition\\.a" "/usr/lib/.*/cmake/artcal/artcalConfig\\.cmake"
        "/usr/share/doc/libartcal-dev/copyright")
if(HAS_PROGRAM)
  set(notice "") # where the system has it
  if(EXISTS /usr/share/doc/libceres-dev/copyright)
    set(notice "/usr/share/doc/artcal/licences/libceres-dev")
  endif()
  expect_package(artcal CONTROL "Package: artcal\n" "Section: science" "Depends: [^\n]*libc6[^\n]*libstdc"
                 FILES "\\./usr/bin/artcal" "/usr/share/doc/artcal/copyright" "/usr/share/artcal/examples/ball-bar/recording\\.toml"
                       "/usr/share/doc/artcal/README\\.md" ${notice}
                       "/usr/share/doc/artcal/docs/files\\.md"
                       "/usr/share/man/man1/artcal\\.1\\.gz" "/usr/share/man/man1/artcal-identify\\.1\\.gz"
                       "/usr/share/bash-completion/completions/artcal" "/usr/share/zsh/vendor-completions/_artcal"
                       "/usr/share/fish/vendor_completions\\.d/artcal\\.fish")
endif()
