#pragma once

#include <optional>
#include <string>
#include <vector>

#include "artefacts/dcc/dcc.h"

namespace artcal {

/// A laboratory or a customer.
struct DccContact {
  std::string name;
  std::string street, street_number, post_code, city;  ///< each may be empty, but for one of them
  std::string country;                                 ///< two letters, ISO 3166-1
  std::string e_mail;                                  ///< may be empty
};

/// What was calibrated.
struct DccItem {
  std::string name, manufacturer, model;  ///< manufacturer and model may be empty
  std::string serial_number;
};

/// What only the laboratory knows. Nothing of it is made up.
struct DccData {
  std::string number;                    ///< of the certificate, unique
  std::string country;                   ///< under whose rules, two letters
  std::string begin, end;                ///< of the measurement, "2026-03-10"
  std::string location;                  ///< "laboratory", "customer", "laboratoryBranch", "customerBranch" or "other"
  std::vector<std::string> responsible;  ///< persons; the first is the main one
  DccContact laboratory, customer;
  DccItem item;
};

/// Whether conformity to a limit was shown. Where neither it nor its contrary was, the certificate says "noPass".
enum class DccConformity { Pass, Fail, NotShown };

/// One number to be written.
struct DccEntry {
  std::string name;
  std::string ref_type;  ///< may be empty; one word
  std::string unit;      ///< D-SI
  double value = 0.0;
  std::optional<DccUncertainty> uncertainty;
  std::optional<DccConformity> conformity;
  std::string limit;  ///< what it was held against and by which rule, for people; goes with `conformity`
};

/// A heading with its numbers.
struct DccResult {
  std::string name;
  std::string description;  ///< may be empty
  std::vector<DccEntry> entries;
};

/// How numbers were found.
struct DccMethod {
  std::string name;
  std::string description;
};

/// A digital calibration certificate to be written. Texts are English and plain.
struct DccDocument {
  DccData data;
  std::string program_version;
  std::vector<std::string> statements;
  std::vector<DccMethod> methods;
  std::vector<DccResult> results;
};

}  // namespace artcal
