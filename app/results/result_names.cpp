#include "app/results/result_names.h"

namespace artcal {

const char* result_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::ConformityProven: return "conforms";
    case Verdict::NonConformityProven: return "does_not_conform";
    case Verdict::NeitherProven: return "nothing_proven";
    case Verdict::NotJudged: break;
  }
  return "not_judged";
}

const char* result_name(Conclusion conclusion) {
  switch (conclusion) {
    case Conclusion::ConformityProven: return "conformity_shown";
    case Conclusion::NonConformityProven: return "non_conformity_shown";
    case Conclusion::ConformityNotShown: break;
  }
  return "not_shown";
}

const char* result_name(ParameterState state) {
  switch (state) {
    case ParameterState::Fixed: return "fixed";
    case ParameterState::Weak: return "weak";
    case ParameterState::Unidentifiable: return "unidentifiable";
    case ParameterState::Identified: break;
  }
  return "identified";
}

const char* result_name(Loss loss) { return loss == Loss::Huber ? "huber" : loss == Loss::Cauchy ? "cauchy" : "none"; }

Verdict verdict_named(std::string_view word) {
  for (const Verdict verdict : {Verdict::ConformityProven, Verdict::NonConformityProven, Verdict::NeitherProven}) {
    if (word == result_name(verdict)) {
      return verdict;
    }
  }
  return Verdict::NotJudged;
}

Conclusion conclusion_named(std::string_view word) {
  for (const Conclusion conclusion : {Conclusion::ConformityProven, Conclusion::NonConformityProven}) {
    if (word == result_name(conclusion)) {
      return conclusion;
    }
  }
  return Conclusion::ConformityNotShown;
}

std::optional<ParameterState> parameter_state_named(std::string_view word) {
  for (const ParameterState state :
       {ParameterState::Identified, ParameterState::Weak, ParameterState::Fixed, ParameterState::Unidentifiable}) {
    if (word == result_name(state)) {
      return state;
    }
  }
  return std::nullopt;
}

}  // namespace artcal
