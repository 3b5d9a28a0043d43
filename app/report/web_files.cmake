# What web_files.S lays into the program. The figures' scripts follow one another as one.
include(${PROJECT_SOURCE_DIR}/cmake/plotly.cmake)
enable_language(ASM)
set(web ${CMAKE_CURRENT_SOURCE_DIR}/report/web)
set(figures_sources)
foreach(name common placements joints lengths correlations scene flat map drift draw)
  list(APPEND figures_sources ${web}/figures/${name}.js)
endforeach()
set(figures ${CMAKE_CURRENT_BINARY_DIR}/generated/figures.js)
add_custom_command(OUTPUT ${figures} COMMAND cat ${figures_sources} > ${figures} DEPENDS ${figures_sources} VERBATIM)
set_source_files_properties(report/web_files.S PROPERTIES
  COMPILE_DEFINITIONS "ARTCAL_PLOTLY_BUNDLE=\"${PLOTLY_BUNDLE}\";ARTCAL_PLOTLY_LICENCE=\"${PLOTLY_LICENCE}\";ARTCAL_FIGURES=\"${figures}\";ARTCAL_MISSING=\"${web}/missing.js\";ARTCAL_SORTING=\"${web}/sorting.js\";ARTCAL_STYLE=\"${web}/style.css\""
  OBJECT_DEPENDS "${figures};${web}/missing.js;${web}/sorting.js;${web}/style.css;${PLOTLY_BUNDLE};${PLOTLY_LICENCE}")
if(ARTCAL_INSTALL)
  include(GNUInstallDirs)
  install(FILES ${PLOTLY_LICENCE} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/artcal RENAME copyright.plotly COMPONENT program)
endif()
