#include "app/results/verification/standard_name.h"

#include "core/text/in_quotes.h"

namespace artcal {

std::string standard_in_words(const std::string& name) {
  return name == "iso10360-12"    ? "ISO 10360-12:2016"
         : name == "b89.4.22"     ? "ASME B89.4.22-2004"
         : name == "sphere-plate" ? "sphere plate (procedure of artcal, no standard)"
                                  : truncated(40, name);
}

}  // namespace artcal
