#include "tests/support/places.h"

namespace artcal_places {

const char* source_folder() { return ARTCAL_SOURCE_FOLDER; }
const char* program_file() { return ARTCAL_PROGRAM_FILE; }

}  // namespace artcal_places
