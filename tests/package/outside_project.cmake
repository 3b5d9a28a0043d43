# Installs artcal into a temporary prefix, and configures, builds and runs a project that knows only that.
set(prefix ${WORK_DIR}/prefix)
set(build ${WORK_DIR}/outside)
file(REMOVE_RECURSE ${prefix} ${build})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command} failed:\n${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${OUTSIDE_DIR} -B ${build} -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
run(${CMAKE_COMMAND} --build ${build})
run(${build}/outside)
run(${build}/outside ${prefix}/share/artcal/examples)
file(GLOB_RECURSE leaked RELATIVE ${prefix} ${prefix}/*.cpp ${prefix}/*toml_document* ${prefix}/*csv.h)
if(leaked)
  message(FATAL_ERROR "These do not belong into an installation: ${leaked}")
endif()
