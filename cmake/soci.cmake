# SOCI with its SQLite backend; Debian's libsoci-dev has no CMake package. Only the program uses it. The backend and SQLite
# are linked statically where that is possible, so that their symbols need not be bound at every start: not into a shared
# library, for Debian's static ones are not position-independent. The backend for PostgreSQL is loaded where a store is on
# a server (app/store/postgresql_backend.h).
find_path(SOCI_INCLUDE_DIR soci/soci.h REQUIRED)
find_library(SOCI_CORE_LIBRARY soci_core REQUIRED)
if(ARTCAL_BUILD_PYTHON)
  find_library(SOCI_SQLITE3_SHARED soci_sqlite3 REQUIRED)
  set(soci_sqlite3 ${SOCI_SQLITE3_SHARED})
else()
  find_library(SOCI_SQLITE3_BACKEND NAMES libsoci_sqlite3.a soci_sqlite3 REQUIRED)
  find_library(SQLITE3_BACKEND NAMES libsqlite3.a sqlite3 REQUIRED)
  set(soci_sqlite3 ${SOCI_SQLITE3_BACKEND} ${SQLITE3_BACKEND})
endif()
if(NOT TARGET artcal::soci)
  add_library(artcal::soci INTERFACE IMPORTED)
  target_include_directories(artcal::soci SYSTEM INTERFACE ${SOCI_INCLUDE_DIR})
  target_link_libraries(artcal::soci INTERFACE ${soci_sqlite3} ${SOCI_CORE_LIBRARY}
                                               ${CMAKE_DL_LIBS})
endif()
