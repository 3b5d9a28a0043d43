#include "artefacts/artefact/length_values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "artefacts/dcc/dcc_length.h"
#include "artefacts/dcc/dcc_select.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

/// Of the certificate, with the labels of the single numbers.
struct LabelledLengths {
  LengthValues lengths;
  std::vector<std::string> labels;  ///< one a value; empty where it has none
};

void append(const DccLengths& more, LabelledLengths& all) {
  for (std::size_t i = 0; i < more.values.size(); ++i) {
    all.lengths.values.push_back(more.values[i]);
    all.labels.push_back(more.labels.empty() ? "" : more.labels[i]);
    CertifiedUncertainty& certified = all.lengths.certified.emplace_back();
    certified.unread = more.unread_uncertainty;
    if (!more.uncertainties.empty()) {
      certified.U = more.uncertainties[i].U;
      certified.k = more.uncertainties[i].k;
    }
  }
}

// The place of the number that `item` names, by its place from 1 or by its label.
std::optional<std::size_t> chosen_item(TomlTable& reference, const std::vector<std::string>& labels) {
  if (reference.is_text("item")) {
    const std::string label = reference.text("item");
    const auto count = std::count(labels.begin(), labels.end(), label);
    if (label.empty() || count != 1) {
      reference.fail("item", fmt::format("{} of the certificate's numbers are labelled {}, expected one", count,
                                         in_quotes(label)));
      return std::nullopt;
    }
    return static_cast<std::size_t>(std::find(labels.begin(), labels.end(), label) - labels.begin());
  }
  const double item = reference.number("item");
  if (item != std::floor(item) || item < 1.0 || item > static_cast<double>(labels.size())) {
    reference.fail("item", fmt::format("item is {}, expected a number from 1 to {}", item, labels.size()));
    return std::nullopt;
  }
  return static_cast<std::size_t>(item) - 1;
}

bool some_lack_uncertainty(const std::vector<CertifiedUncertainty>& all) {
  const auto stated = std::count_if(all.begin(), all.end(), [](const auto& one) { return one.U.has_value(); });
  return stated != 0 && stated != std::ssize(all);
}

LengthValues from_certificate(TomlTable& table, std::string_view key, const ArtefactValues& values) {
  TomlTable reference = table.table(key);
  LabelledLengths all;
  const auto names = reference.is_text("dcc") ? std::vector{reference.text("dcc")} : reference.texts("dcc");
  if (names.empty()) {
    reference.fail("dcc", "expected the certificate's quantity, such as { dcc = \"diameter A\" }");
  } else if (values.dcc == nullptr) {
    reference.fail("dcc", "the file names no digital certificate; write dcc = \"certificate.xml\" at its top");
    return {};
  }
  for (const auto& name : names) {
    const auto lengths = find_quantity(*values.dcc, name).and_then(lengths_of);
    if (!lengths) {
      reference.fail("dcc", lengths.error().text());
      return {};
    }
    append(*lengths, all);
  }
  if (reference.has("item")) {
    const auto item = chosen_item(reference, all.labels);
    return item ? LengthValues{{all.lengths.values[*item]}, {all.lengths.certified[*item]}} : LengthValues{};
  }
  if (some_lack_uncertainty(all.lengths.certified)) {
    reference.fail("dcc", "of these quantities some have an uncertainty in the certificate and some have none");
    return {};
  }
  return all.lengths;
}

}  // namespace

CertifiedUncertainty LengthValues::largest_certified() const {
  CertifiedUncertainty largest;
  for (const CertifiedUncertainty& one : certified) {
    if (largest.unread.empty()) {
      largest.unread = one.unread;
    }
    if (one.u() > largest.u()) {  // nothing is less than any
      largest.U = one.U;
      largest.k = one.k;
    }
  }
  return largest;
}

LengthValues read_lengths(TomlTable& table, std::string_view key, const ArtefactValues& values) {
  if (table.is_table(key)) {
    return from_certificate(table, key, values);
  }
  LengthValues lengths{table.numbers(key), {}};
  for (double& value : lengths.values) {
    value *= values.length;
  }
  return lengths;
}

LengthValues read_length(TomlTable& table, std::string_view key, const ArtefactValues& values) {
  if (!table.is_table(key)) {
    return {{table.number(key) * values.length}, {}};
  }
  LengthValues lengths = from_certificate(table, key, values);
  if (lengths.values.size() != 1) {
    table.fail(key, fmt::format("the certificate's quantity holds {} numbers, expected one; choose it with item = 1 …",
                                lengths.values.size()));
    return {{1.0}, {}};
  }
  return lengths;
}

}  // namespace artcal
