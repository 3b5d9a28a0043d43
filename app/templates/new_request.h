#pragma once

#include <string>
#include <vector>

#include "app/templates/arm_template.h"
#include "app/templates/artefact_template.h"
#include "app/templates/plan_template.h"
#include "app/templates/recording_template.h"

namespace artcal {

/// `artcal new arm|artefact|plan|recording`: a commented file to start from, by options or, on a terminal without them,
/// by questions.
class NewRequest {
 public:
  void add_to(CLI::App& parser);
  [[nodiscard]] Expected<int> run();

 private:
  ArmTemplate arm_;
  ArtefactTemplate artefact_;
  PlanTemplate plan_;
  RecordingTemplate recording_;
  std::string output_;
  bool quiet_ = false;
  std::vector<CLI::App*> commands_;  // in this order
};

}  // namespace artcal
