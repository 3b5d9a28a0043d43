#include "identification/identifiability/unidentifiable_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

namespace artcal {
namespace {

// A weak direction has a bit of everything; its largest parts tell what it is.
constexpr std::ptrdiff_t max_terms = 5;

struct Term {
  const Parameter* parameter;
  double coefficient;
};

std::vector<Term> terms_of(const Coupling& coupling, const ParameterMotion& motion) {
  std::vector<Term> terms;
  for (Eigen::Index i = 0; i < motion.coefficients.size(); ++i) {
    if (motion.coefficients[i] != 0.0) {
      terms.push_back({&coupling.parameters[i], motion.coefficients[i]});
    }
  }
  return terms;
}

// Five digits, no trailing zeros.
std::string number(double value) { return fmt::format("{:.5g}", value); }

// "+ 12.102 d3", "- a6/183.5": a small factor is read more easily as a division.
std::string signed_term(double coefficient, const std::string& name) {
  const double size = std::abs(coefficient);
  const std::string sign = coefficient < 0.0 ? "-" : "+";
  if (std::abs(size - 1.0) < 5e-6) {
    return fmt::format("{} {}", sign, name);
  }
  if (size < 0.1) {
    return fmt::format("{} {}/{}", sign, name, number(1.0 / size));
  }
  return fmt::format("{} {} {}", sign, number(size), name);
}

std::string joined(const std::vector<Term>& terms) {
  std::string text;
  for (const Term& term : terms) {
    text += (text.empty() ? "" : " ") + signed_term(term.coefficient, term.parameter->name);
  }
  return text.starts_with("+ ") ? text.substr(2) : text;
}

}  // namespace

std::string unidentifiable_as_motion(const Coupling& coupling, const ParameterMotion& motion) {
  std::string text;
  for (const Term& term : terms_of(coupling, motion)) {
    text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", term.parameter->name,
                        term.coefficient < 0.0 ? "-" : "+", number(std::abs(term.coefficient)));
  }
  return text;
}

std::string unidentifiable_in_words(const Coupling& coupling, const ParameterMotion& motion) {
  const auto terms = terms_of(coupling, motion);
  const std::string& fixed = coupling.parameters[motion.leading].name;
  if (terms.size() == 1 && terms.front().parameter->kind == ParameterKind::Radius) {
    return fmt::format(
        "{} is not identifiable: only its sum with the unknown radius of a ball or the unknown place of a plane is "
        "seen",
        fixed);
  }
  if (terms.size() == 1) {
    return fmt::format("{} is not identifiable", fixed);
  }
  if (terms.size() == 2) {
    const Term& other = terms[terms[0].parameter->name == fixed ? 1 : 0];
    // Moving the held one by 1 and the other by c is not seen, so other − c·held is what stays.
    return fmt::format("{} {} is identifiable, {} alone is not", other.parameter->name,
                       signed_term(-other.coefficient, fixed), fixed);
  }
  return fmt::format("{} change together without any effect, {} alone is not identifiable", joined(terms), fixed);
}

std::string weak_in_words(const Coupling& coupling, const WeakDirection& weak) {
  auto terms = terms_of(coupling, weak.motion);
  const auto in_millimetres = [&](const Term& term) {
    return std::abs(term.coefficient) / physical_scale(*term.parameter, coupling.angle_scale);
  };
  std::sort(terms.begin(), terms.end(),
            [&](const Term& a, const Term& b) { return in_millimetres(a) > in_millimetres(b); });
  const double largest = terms.empty() ? 0.0 : in_millimetres(terms.front());
  const auto small =
      std::find_if(terms.begin(), terms.end(), [&](const Term& term) { return in_millimetres(term) < 0.1 * largest; });
  const auto shown = std::min(small, terms.begin() + std::min<std::ptrdiff_t>(max_terms, std::ssize(terms)));
  const bool more = shown != terms.end();
  terms.erase(shown, terms.end());
  return joined(terms) + (more ? " and smaller parts" : "") +
         (weak.share_of_scale > 0.7 ? ": mostly the scale of all lengths" : "");
}

}  // namespace artcal
