# `cpack` makes Debian packages: artcal, the program; libartcal-dev, what other projects build on; and with the preset
# python also python3-artcal.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME artcal)
set(CPACK_PACKAGE_VENDOR "artcal")
set(CPACK_PACKAGE_CONTACT "artcal maintainers")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_COMPONENTS_ALL program development)

set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "Turns readings of an articulated-arm coordinate measuring machine on calibrated artefacts into\n"
    "the arm's identified kinematic parameters with their uncertainty, and verifies the arm.")
list(JOIN CPACK_COMPONENT_PROGRAM_DESCRIPTION "" CPACK_COMPONENT_PROGRAM_DESCRIPTION)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME artcal)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS libsoci-postgresql4.0) # loaded for stores on a server

set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Static libraries, headers and CMake package of artcal.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libartcal-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    libeigen3-dev libceres-dev libexpected-dev libfmt-dev libboost-dev libssl-dev libtomlplusplus-dev
    libcgal-dev libpcl-dev libpugixml-dev liblzf-dev libyaml-cpp-dev)
list(JOIN CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)

if(ARTCAL_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "artcal for Python: identification, verification and uncertainty of arms.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-artcal)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  # The extension module is for one minor version of Python.
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-matplotlib")
endif()

include(CPack)
