#include "artefacts/dcc/dcc_select.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/xml/xml.h"

namespace artcal {
namespace {

constexpr std::size_t max_quantities_listed = 12;

bool holds(const std::vector<std::string>& all, std::string_view one) {
  return std::find(all.begin(), all.end(), one) != all.end();
}

bool is_called(const DccLabels& labels, std::string_view name) {
  return labels.id == name || holds(labels.names, name) || holds(labels.ref_types, name);
}

// "part/…/name": the last is the quantity's own, the others are in order among what it is in.
bool is_at(const DccQuantity& quantity, std::string_view key) {
  const auto last = key.rfind('/');
  if (last == std::string_view::npos || !is_called(quantity.labels, key.substr(last + 1))) {
    return false;
  }
  std::string_view parts = key.substr(0, last);
  for (auto outer = quantity.within.rbegin(); outer != quantity.within.rend(); ++outer) {
    const auto slash = parts.rfind('/');
    if (is_called(**outer, slash == std::string_view::npos ? parts : parts.substr(slash + 1))) {
      if (slash == std::string_view::npos) {
        return true;
      }
      parts = parts.substr(0, slash);
    }
  }
  return false;
}

template <typename Predicate>
std::vector<const DccQuantity*> which(const DccCertificate& certificate, Predicate predicate) {
  std::vector<const DccQuantity*> found;
  for (const DccQuantity& quantity : certificate.quantities) {
    if (predicate(quantity)) {
      found.push_back(&quantity);
    }
  }
  return found;
}

std::vector<const DccQuantity*> candidates(const DccCertificate& certificate, std::string_view key) {
  auto found = which(certificate, [&](const DccQuantity& q) { return q.labels.id == key; });
  if (found.empty()) {
    found = which(certificate, [&](const DccQuantity& q) { return holds(q.labels.names, key); });
  }
  if (found.empty()) {
    found = which(certificate, [&](const DccQuantity& q) { return holds(q.labels.ref_types, key); });
  }
  if (found.empty()) {
    found = which(certificate, [&](const DccQuantity& q) { return is_at(q, key); });
  }
  return found;
}

std::string list_of(const std::vector<const DccQuantity*>& quantities) {
  std::string text;
  for (std::size_t i = 0; i < std::min(max_quantities_listed, quantities.size()); ++i) {
    text += (i == 0 ? "" : "; ") + quantities[i]->text();
  }
  if (quantities.size() > max_quantities_listed) {
    text += fmt::format("; and {} more", quantities.size() - max_quantities_listed);
  }
  return text;
}

std::string label_of(const DccLabels& labels) {
  return truncated(40, !labels.names.empty()       ? labels.names.back()
                       : !labels.id.empty()        ? labels.id
                       : !labels.ref_types.empty() ? labels.ref_types.front()
                                                   : "");
}

}  // namespace

std::string DccQuantity::text() const {
  std::string place;
  for (const auto& outer : within) {
    if (const std::string label = label_of(*outer); !label.empty()) {
      place += label + "/";
    }
  }
  place += label_of(labels);
  if (!labels.id.empty()) {
    place += fmt::format(" (id {})", truncated(40, labels.id));
  }
  if (!labels.ref_types.empty()) {
    place += fmt::format(" [{}]", truncated(40, labels.ref_types.front()));
  }
  if (fault) {
    return fmt::format("{} (not read: {})", place, truncated(80, fault->message));
  }
  const DccNumbers& first = numbers();
  return fmt::format("{} = {}{} {}", place, first.values.front(), first.values.size() > 1 ? " …" : "",
                     truncated(40, first.units.front()));
}

std::string list_of_quantities(const DccCertificate& certificate) {
  return list_of(which(certificate, [](const DccQuantity&) { return true; }));
}

Expected<DccQuantity> find_quantity(const DccCertificate& certificate, std::string_view key) {
  const auto found = candidates(certificate, in_one_line_of_words(key));
  if (found.size() == 1) {
    return found.front()->fault ? Expected<DccQuantity>(tl::unexpected(*found.front()->fault)) : *found.front();
  }
  if (certificate.quantities.empty()) {
    return bad_input(fmt::format("the certificate {} has no quantity {}, and no other with a number",
                                 in_quotes(certificate.input.path), in_quotes(key)));
  }
  if (found.empty()) {
    return bad_input(fmt::format("the certificate {} has no quantity {}; it has: {}", in_quotes(certificate.input.path),
                                 in_quotes(key), list_of_quantities(certificate)));
  }
  return bad_input(
      fmt::format("{} quantities of the certificate {} are called {}; name one by its id, or with the name of "
                  "what it is in before it (\"table/name\"): {}",
                  found.size(), in_quotes(certificate.input.path), in_quotes(key), list_of(found)));
}

}  // namespace artcal
