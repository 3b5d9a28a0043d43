#include "artefacts/verification/iso10360_12/iso10360_12.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "artefacts/verification/decision/completeness.h"
#include "artefacts/verification/decision/conclusion.h"
#include "artefacts/verification/decision/outlier_rule.h"
#include "artefacts/verification/iso10360_12/face_tests.h"
#include "artefacts/verification/iso10360_12/length_tests.h"
#include "artefacts/verification/iso10360_12/sphere_tests.h"
#include "artefacts/verification/point_uncertainty.h"

namespace artcal {
namespace {

constexpr std::array quantities{Quantity::SizeError,    Quantity::FormError,        Quantity::SizeErrorAll,
                                Quantity::FormErrorD95, Quantity::LocationDiameter, Quantity::LengthUni,
                                Quantity::LengthBi};

// Why points of a scan do not do for a quantity that single contacts are asked for.
std::string by_scan_only(Quantity quantity, const Verification& verification) {
  const bool is_contact = quantity == Quantity::SizeError || quantity == Quantity::FormError;
  const bool scanned = worst_of(verification, Quantity::FormErrorD95) != nullptr;
  return is_contact && scanned
             ? " in single points; a scan gives P_Size.Sph.All and P_Form.Sph.D95%, which have limits "
               "of their own"
             : "";
}

// A limit that nothing was measured for is a test that was not made.
void check_limits(const Session& session, Verification& verification) {
  for (const Quantity quantity : quantities) {
    if (session.specification.limits.contains(quantity) && worst_of(verification, quantity) == nullptr) {
      verification.missing.push_back(fmt::format("{}: a limit is stated, but nothing was measured{}", name_of(quantity),
                                                 by_scan_only(quantity, verification)));
    }
  }
}

}  // namespace

Expected<Verification> verify_iso10360_12(const Session& session) {
  Verification verification;
  verification.standard = "iso10360-12";
  verification.rule = session.specification.rule;
  add_sphere_tests(session, verification);
  add_length_tests(session, Quantity::LengthUni, verification);
  add_face_tests(session, verification);
  if (verification.values.empty()) {
    return no_solution("nothing of ISO 10360-12 can be evaluated: " +
                       (verification.missing.empty()
                            ? "there is neither a single ball nor a certified length with both ends read"
                            : verification.missing.front()));
  }
  add_point_uncertainties(session, verification);
  const int repeats = session.specification.plan ? session.specification.plan->repeats : 0;
  set_outliers_aside(session.specification.outliers, repeats, verification);
  check_sphere_plan(session, verification);
  check_length_plan(session, verification);
  check_limits(session, verification);
  check_and_conclude(session, verification);
  return verification;
}

}  // namespace artcal
