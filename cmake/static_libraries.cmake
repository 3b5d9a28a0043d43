# Loading 36 shared libraries and binding their symbols was most of what a start of the program took (docs/benchmarks.md,
# "Starting the program"), half of them for the logging and the sparse solvers of Ceres. Libraries of which Debian has a static
# one beside the shared one are linked statically. Not for Python: a shared library takes position-independent code only.

function(artcal_link_statically target)
  if(NOT TARGET ${target})
    return()
  endif()
  foreach(location IMPORTED_LOCATION IMPORTED_LOCATION_NONE IMPORTED_LOCATION_RELEASE)
    get_target_property(shared ${target} ${location})
    if(shared)
      string(REGEX REPLACE "\\.so[.0-9]*$" ".a" static ${shared})
      if(EXISTS ${static})
        set_target_properties(${target} PROPERTIES ${location} ${static})
      endif()
    endif()
  endforeach()
endfunction()

foreach(target gflags pugixml::shared yaml-cpp CXSparse::CXSparse SuiteSparse::AMD SuiteSparse::CAMD SuiteSparse::CCOLAMD
               SuiteSparse::COLAMD SuiteSparse::Config SuiteSparse::SPQR)
  artcal_link_statically(${target})
endforeach()

# What a static library needs itself, of which Debian has the shared one only.
find_library(UNWIND_LIBRARY NAMES libunwind.so.8 unwind)
if(UNWIND_LIBRARY)
  artcal_link_statically(glog::glog)
  target_link_libraries(glog::glog INTERFACE ${UNWIND_LIBRARY})
endif()
find_library(METIS_LIBRARY_OF_CHOLMOD NAMES libmetis.so.5 metis)
find_package(OpenMP COMPONENTS CXX)
if(METIS_LIBRARY_OF_CHOLMOD AND OpenMP_CXX_FOUND)
  artcal_link_statically(SuiteSparse::CHOLMOD)
  target_link_libraries(SuiteSparse::CHOLMOD INTERFACE ${METIS_LIBRARY_OF_CHOLMOD} ${OpenMP_CXX_LIBRARIES})
endif()
