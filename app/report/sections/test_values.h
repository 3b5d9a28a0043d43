#pragma once

#include <string>
#include <vector>

#include "app/report/sheet.h"
#include "app/results/verification/recorded_value.h"

namespace artcal {

/// The values of a verification of one quantity, in their order.
struct ValuesOfQuantity {
  std::string quantity;
  std::vector<const RecordedValue*> values;
  const RecordedValue* worst = nullptr;  ///< see worst_is; null where all are set aside
};

/// Which value of a quantity is called its worst: said wherever one is shown.
inline constexpr const char* worst_is = "the value with the largest share of its limit (without a limit, the largest)";

/// "93 %": what a value uses up of its limit; "–" without a limit.
std::string share_in_words(const RecordedValue& value);

/// Refers to `values`, which must stay.
std::vector<ValuesOfQuantity> by_quantity(const std::vector<RecordedValue>& values);

/// With a sign and hyphen that do not break: "✓ conformity proven", "✗ non-conformity proven", …; "set aside" where it
/// was measured again.
std::string verdict_in_words(const RecordedValue& value);

/// Signed where the value is an error, in micrometres.
std::string value_in_words(const RecordedValue& value);

void write_worst_values(const std::vector<ValuesOfQuantity>& quantities, Sheet& sheet);
/// Errors of lengths over length with the band of their limits; nothing where no length was measured.
void write_errors_over_length(const std::vector<ValuesOfQuantity>& quantities, Sheet& sheet);
/// What octant and reach mean in write_values().
void write_places_explained(Sheet& sheet);
/// Every value; of very many, all whose non-conformity is proven and those nearest to their limits.
void write_values(const ValuesOfQuantity& quantity, Sheet& sheet);

}  // namespace artcal
