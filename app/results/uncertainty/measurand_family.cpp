#include "app/results/uncertainty/measurand_family.h"

namespace artcal {

std::string measurand_family(const std::string& kind, const std::string& name) {
  return kind == "coordinate" ? "coordinate of " + name.substr(0, name.rfind(' '))
         : kind == "length"   ? name.substr(0, name.rfind(','))
         : kind == "E_Uni"    ? "E_Uni, " + name.substr(0, name.rfind(','))
         : kind == "P_Size"   ? "P_Size, 25 points"
         : kind == "L_Dia"    ? "L_Dia, 5 x 5"
                              : "";
}

}  // namespace artcal
