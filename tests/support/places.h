#pragma once

/// Where the tree and the program that is tested are. Included in every test by the compiler's command line: as texts
/// in a macro of their own they would make every object differ from tree to tree, and no compiler cache could serve a
/// second clone.
namespace artcal_places {

const char* source_folder();
const char* program_file();

}  // namespace artcal_places

#define ARTCAL_SOURCE_DIR (artcal_places::source_folder())
#define ARTCAL_PROGRAM (artcal_places::program_file())
