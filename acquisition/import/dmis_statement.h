#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace artcal {

/// One statement of DMIS (ANSI/DMSC 105.0): `LABEL(name)=MAJOR/field,field,…`. Words are in capitals here.
struct DmisStatement {
  int line = 0;                     ///< where it begins, from 1
  std::string label_kind, label;    ///< "FA" and "SPH1" of FA(SPH1)=…; empty where there is none
  std::string major;                ///< the word before the slash; empty of what is no statement of this form
  std::vector<std::string> fields;  ///< behind the slash, without the blanks around them; quotes are kept
};

/// The statements of a text: comments behind $$ and blank lines are passed over, a $ at the end of a line joins the
/// next one to it.
std::vector<DmisStatement> dmis_statements(std::string_view text);

/// The name in a field such as F(SPH1) or FA(SPH1) of that kind; empty where it is none.
std::string name_in(std::string_view field, std::string_view kind);

}  // namespace artcal
