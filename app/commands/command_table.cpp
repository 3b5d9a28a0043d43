#include "app/commands/command_table.h"

namespace artcal {

const std::vector<Command>& command_table() {
  static const std::vector<Command> commands{
      Command{"fit", "fit one feature to a file of points", set_up_fit},
      Command{"record", "take readings from an arm into a recording, each on disk at once", set_up_record},
      Command{"inspect", "look for mistakes in a recording before it is solved", set_up_inspect},
      Command{"identify", "identify an arm's parameters from its readings on artefacts", set_up_identify},
      Command{"evaluate", "evaluate an arm on readings, such as an identified one on new readings", set_up_evaluate},
      Command{"coupling", "identifiability analysis: which parameters readings determine", set_up_coupling},
      Command{"segment", "find an artefact's spheres and planes in a scan", set_up_segment},
      Command{"uncertainty", "measurement uncertainty of an identified arm: points, lengths, volume",
              set_up_uncertainty},
      Command{"verify", "verify an arm: ISO 10360-12, ASME B89.4.22, sphere plate", set_up_verify},
      Command{"points", "coordinates from joint angles", set_up_points},
      Command{"plan", "propose placements and postures of the next readings", set_up_plan},
      Command{"simulate", "a recording made by a virtual arm, with its true values", set_up_simulate},
      Command{"report", "report of results (HTML, prints on A4)", set_up_report},
      Command{"convert", "tables of a result as CSV", set_up_convert},
      Command{"new", "a commented arm, artefact, plan or recording to start from", set_up_new},
      Command{"import", "readings from files of other programs: text tables, PC-DMIS, DMIS, QIF", set_up_import},
      Command{"arm", "arms from and to other programs' files; rounding; a maker's own model", set_up_arm},
      Command{"batch", "identify and verify many recordings, results into a store", set_up_batch},
      Command{"history", "changes of an arm over time; results that rest on a certificate", set_up_history},
      Command{"store", "merge, print or prune stores", set_up_store},
      Command{"help", "describe the program or a command, as --help does", set_up_help},
      Command{"completion", "a script that completes command lines in a shell", set_up_completion},
  };
  return commands;
}

}  // namespace artcal
