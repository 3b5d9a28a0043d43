# artcal_migrations(TARGET FOLDER): the numbered SQL files of a folder, compiled in as app/store/migration_texts.cpp.
function(artcal_migrations target folder)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.sql)
  list(SORT files)
  set(entries "")
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND entries "    {\"${name}\", R\"sql(${text})sql\"},\n")
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/generated/app/store/migration_texts.cpp)
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
"#include \"app/store/migrations.h\"

namespace artcal {

const std::vector<Migration>& store_migrations() {
  static const std::vector<Migration> all{
@entries@  };
  return all;
}

}  // namespace artcal
")
  target_sources(${target} PRIVATE ${source})
endfunction()
