#include "app/store/shape.h"

namespace artcal {
namespace {

constexpr auto text = ColumnKind::Text;
constexpr auto whole = ColumnKind::Whole;
constexpr auto real = ColumnKind::Real;

std::array<TableShape, store_table_count> make_shapes() {
  return {{
      {"arms", {{"arm", text}}, 1},
      {"artefacts", {{"artefact", text}, {"name", text}, {"type", text}}, 1},
      {"certificates",
       {{"certificate", text},
        {"artefact", text},
        {"number", text},
        {"laboratory", text},
        {"issued_on", text},
        {"valid_until", text}},
       1},
      {"recordings",
       {{"recording", text},
        {"program", text},
        {"options", text},
        {"name", text},
        {"measured_on", text},
        {"arm", text},
        {"readings", whole},
        {"exit_code", whole},
        {"error", text}},
       1},
      {"inputs", {{"recording", text}, {"position", whole}, {"path", text}, {"sha256", text}}, 2},
      {"used_certificates", {{"recording", text}, {"certificate", text}}, 2},
      {"identifications",
       {{"recording", text},
        {"rank", whole},
        {"noise_mm", real},
        {"noise_is_given", whole},
        {"chi_squared", real},
        {"degrees_of_freedom", whole},
        {"scale_factor", real},
        {"rms_before_mm", real},
        {"maximum_before_mm", real},
        {"rms_after_mm", real},
        {"maximum_after_mm", real},
        {"rms_left_out_mm", real},
        {"outliers", whole},
        {"covariance", text},
        {"arm_file", text},
        {"unidentifiable", text}},
       1},
      {"parameters",
       {{"recording", text},
        {"position", whole},
        {"name", text},
        {"unit", text},
        {"state", text},
        {"nominal", real},
        {"identified", real},
        {"u", real},
        {"degrees_of_freedom", real},
        {"coverage_factor", real}},
       2},
      {"verifications",
       {{"recording", text},
        {"standard", text},
        {"specification", text},
        {"decision_rule", text},
        {"conclusion", text}},
       1},
      {"verification_values",
       {{"recording", text},        {"position", whole},      {"quantity", text},         {"artefact", text},
        {"placement", text},        {"feature", text},        {"other_feature", text},    {"repetition", text},
        {"certified_mm", real},     {"measured_mm", real},    {"value_mm", real},         {"temperature_c", real},
        {"limit_mm", real},         {"u_mm", real},           {"u_calibration_mm", real}, {"u_expansion_mm", real},
        {"u_temperature_mm", real}, {"u_alignment_mm", real}, {"u_fixture_mm", real},     {"u_form_mm", real},
        {"verdict", text},          {"set_aside", whole},     {"u_points_mm", real},      {"degrees_of_freedom", real},
        {"coverage_factor", real}},
       2},
      {"remarks", {{"recording", text}, {"position", whole}, {"kind", text}, {"remark", text}}, 2},
      {"files", {{"path", text}, {"recording", text}, {"exit_code", whole}, {"error", text}}, 1},
      {"stored", {{"recording", text}, {"stored_at", text}}, 1},
  }};
}

}  // namespace

const TableShape& shape_of(StoreTable table) {
  static const auto shapes = make_shapes();
  return shapes[static_cast<std::size_t>(table)];
}

std::string text_or_empty(const StoreValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : std::string();
}

}  // namespace artcal
