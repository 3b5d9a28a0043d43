# artcal_layer(NAME PUBLIC_HEADERS … SOURCES … LINKS … PRIVATE_LINKS … PRECOMPILED …)
#
# One static library per folder, artcal::NAME. PUBLIC_HEADERS are installed and may show only
# Eigen, tl::expected and the standard library; everything else stays behind SOURCES.
function(artcal_layer name)
  cmake_parse_arguments(LAYER "" "" "PUBLIC_HEADERS;SOURCES;LINKS;PRIVATE_LINKS;PRECOMPILED" ${ARGN})
  set(target artcal_${name})
  add_library(${target} STATIC ${LAYER_SOURCES})
  add_library(artcal::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
                                  FILES ${LAYER_PUBLIC_HEADERS})
  target_link_libraries(${target} PUBLIC ${LAYER_LINKS} PRIVATE ${LAYER_PRIVATE_LINKS})
  artcal_compile_options(${target})
  artcal_join_folders(${target})
  artcal_precompile(${target} ${LAYER_PRECOMPILED})
  set_property(GLOBAL APPEND PROPERTY ARTCAL_LAYERS ${target})
endfunction()

# The sources of a folder are compiled as one where CMAKE_UNITY_BUILD is set: most of the time goes into headers and into
# Eigen's templates, which are then read once a folder (docs/benchmarks.md). A source must not call what its neighbour
# declares for itself; tests/names_test.cpp holds that.
function(artcal_join_folders target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "in_${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# Where ARTCAL_PRECOMPILE_HEADERS is set, the target reads cmake/precompiled.h compiled. With OF_ITS_OWN it compiles the header
# itself, with its own options: g++ takes none that was compiled with others.
function(artcal_precompile target)
  if(NOT ARTCAL_PRECOMPILE_HEADERS)
    return()
  endif()
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>) # for ccache
  if("OF_ITS_OWN" IN_LIST ARGN)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
    return()
  endif()
  if(NOT TARGET artcal_precompiled)
    add_library(artcal_precompiled OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    target_include_directories(artcal_precompiled PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(artcal_precompiled PRIVATE Eigen3::Eigen tl::expected fmt::fmt nlohmann_json::nlohmann_json)
    artcal_compile_options(artcal_precompiled)
    target_precompile_headers(artcal_precompiled PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h)
  endif()
  target_precompile_headers(${target} REUSE_FROM artcal_precompiled)
endfunction()

function(artcal_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # The same digits everywhere: no fused multiply-add behind the back of the source.
  target_compile_options(${target} PRIVATE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow
                         -Wconversion -Wno-sign-conversion
                         $<$<BOOL:${ARTCAL_WARNINGS_AS_ERRORS}>:-Werror>)
  # Of a precompiled header g++ 12 no longer knows that it is a system's, and warns of std::string's own copies, where they
  # are sound (GCC's bugs 105329 and 105651).
  if(ARTCAL_PRECOMPILE_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  endif()
endfunction()
