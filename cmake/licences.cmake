# What the packages hold of others' code, compiled in from headers or linked statically, goes with their notices, as their
# licences ask. Boost, SOCI, SQLite and tl::expected ask for none of a program; Plotly's stands in each page that embeds it.
foreach(package libceres-dev libcgal-dev libcli11-dev libeigen3-dev libflann-dev libgflags-dev libgmp-dev libgoogle-glog-dev
                libpcl-dev libpugixml-dev libsuitesparse-dev libyaml-cpp-dev nlohmann-json3-dev)
  set(notice /usr/share/doc/${package}/copyright)
  if(EXISTS ${notice}) # not on a system that leaves documentation out, nor on another than Debian
    install(FILES ${notice} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/artcal/licences RENAME ${package} COMPONENT program)
  endif()
endforeach()
