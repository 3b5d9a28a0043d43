#include "app/import/import_request.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "acquisition/import/column_roles.h"
#include "acquisition/import/pcdmis_report.h"
#include "acquisition/recording/recording_file.h"
#include "app/import/import_preview.h"
#include "app/output/output.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_text.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_import = std::size_t{64} << 20;

const std::map<std::string, Delimiter>& delimiters() {
  static const std::map<std::string, Delimiter> known{{"semicolon", Delimiter::Semicolon},
                                                      {"tab", Delimiter::Tab},
                                                      {"comma", Delimiter::Comma},
                                                      {"blank", Delimiter::Blanks}};
  return known;
}

bool any_column(const ImportedReadings& readings, bool (*is_such)(const std::string&)) {
  return std::any_of(readings.columns.begin(), readings.columns.end(), is_such);
}

// A path as the recording names it from its own folder.
std::string from_folder(const std::string& file, const std::string& folder) {
  std::error_code ignored;
  const fs::path relative = fs::relative(file, fs::absolute(folder, ignored), ignored);
  return relative.empty() ? fs::absolute(file, ignored).string() : relative.string();
}

Expected<ImportedReadings> read(const ImportRequest& request) {
  const auto file = read_text_file(request.input, largest_import);
  if (!file) {
    return tl::unexpected(file.error());
  }
  const bool is_report = request.format == "pc-dmis" || (request.format == "auto" && is_pcdmis_report(*file));
  if (is_report && !(request.columns.empty() && request.separator.empty() && request.skip == 0)) {
    return wrong_usage(
        "--columns, --separator and --skip are for tables, and this is a PC-DMIS report; --format text takes it as a "
        "table all the same");
  }
  if (is_report) {
    return import_pcdmis_report(*file);
  }
  TextImport options{request.columns, std::nullopt, request.skip};
  if (!request.separator.empty()) {
    options.delimiter = delimiters().at(request.separator);
  }
  return import_text(*file, options);
}

// The unit that the file states, or the person; the same where both do.
Expected<std::string> length_unit_of(const ImportRequest& request, const ImportedReadings& readings) {
  if (!request.unit.empty() && !readings.length_unit.empty() && request.unit != readings.length_unit) {
    return wrong_usage(
        fmt::format("--unit is {}, but the file states {}", in_quotes(request.unit), in_quotes(readings.length_unit)));
  }
  const std::string unit = request.unit.empty() ? readings.length_unit : request.unit;
  if (any_column(readings, is_length_role) && unit.empty()) {
    return wrong_usage("the file does not state the unit of its lengths; say it with --unit mm, um, m or in");
  }
  return unit;
}

Expected<std::string> recording_text(const ImportRequest& request, const ImportedReadings& readings,
                                     const std::string& length_unit) {
  const bool has_joints = any_column(readings, is_joint_role);
  if (has_joints && request.joint_unit.empty()) {
    return wrong_usage("the file has joint angles; say their unit with --joint-unit deg, rad, mrad or arcsec");
  }
  if (has_joints && request.arm.empty()) {
    return wrong_usage("the file has joint angles; name the arm that they belong to with --arm arm.toml");
  }
  const auto radius = length_quantity(request.probe_radius);
  if (request.arm.empty() && !radius) {
    return wrong_usage(
        request.probe_radius.empty()
            ? "say the radius of the tip that took the coordinates, such as --probe-radius \"3 mm\" (0 mm "
              "for points of the surface or centres)"
            : fmt::format("--probe-radius is {}, expected a length with its unit, such as \"3 mm\"",
                          in_quotes(request.probe_radius)));
  }
  std::string units = has_joints ? fmt::format("joint = {}", toml_text(request.joint_unit)) : "";
  if (!length_unit.empty()) {
    units += fmt::format("{}length = {}", units.empty() ? "" : ", ", toml_text(length_unit));
  }
  std::string text = fmt::format(
      "# Imported from {}.\nschema = \"artcal-recording/1\"\nname = {}\n{}artefacts = [{}]\nreadings = "
      "[\"readings.csv\"]\nunits = {{ {} }}\n",
      truncated(200, fs::path(request.input).filename().string()),
      toml_text(truncated(80, fs::path(request.input).stem().string())),
      request.arm.empty() ? "" : fmt::format("arm = {}\n", toml_text(from_folder(request.arm, request.folder))),
      toml_text(from_folder(request.artefact, request.folder)), units);
  if (request.arm.empty()) {
    // In the recording's unit.
    text += fmt::format("\n[[probe]]\nradius = {}\n", toml_number(*radius / *artcal::length_unit(length_unit)));
  }
  return text;
}

Expected<void> check_folder(const std::string& folder) {
  std::error_code ignored;
  for (const char* name : {"readings.csv", "recording.toml"}) {
    if (fs::exists(fs::path(folder) / name, ignored)) {
      return wrong_usage(fmt::format("{} is there already; give another folder", (fs::path(folder) / name).string()));
    }
  }
  fs::create_directories(folder, ignored);
  return fs::is_directory(folder, ignored) ? Expected<void>{} : bad_input("the folder cannot be made", folder);
}

}  // namespace

Expected<int> ImportRequest::run() const {
  if (!unit.empty() && !artcal::length_unit(unit)) {
    return wrong_usage(fmt::format("--unit is {}, expected mm, um, m or in", in_quotes(unit)));
  }
  if (!joint_unit.empty() && !angle_unit(joint_unit)) {
    return wrong_usage(fmt::format("--joint-unit is {}, expected deg, rad, mrad or arcsec", in_quotes(joint_unit)));
  }
  const auto readings = read(*this);
  if (!readings) {
    return tl::unexpected(readings.error());
  }
  const std::string preview = quiet ? "" : import_preview(input, *readings);
  if (folder.empty()) {
    fmt::print("{}Nothing was written; add -o FOLDER to keep it.\n", preview);
    return 0;
  }
  const auto length = length_unit_of(*this, *readings);
  const auto recording =
      length && !artefact.empty() ? recording_text(*this, *readings, *length) : Expected<std::string>("");
  if (!length || !recording) {
    return tl::unexpected(length ? recording.error() : length.error());
  }
  if (auto made = check_folder(folder); !made) {
    return tl::unexpected(made.error());
  }
  const fs::path table = fs::path(folder) / "readings.csv", whole = fs::path(folder) / "recording.toml";
  if (auto done = write_file(table.string(), readings_csv(*readings)); !done) {
    return tl::unexpected(done.error());
  }
  if (artefact.empty()) {
    if (!quiet) {
      fmt::print("{}The readings are in {}{}. With --artefact FILE a recording is written that names them.\n", preview,
                 table.string(), length->empty() ? "" : fmt::format(", lengths in {}", *length));
    }
    return 0;
  }
  if (auto done = write_file(whole.string(), *recording); !done) {
    return tl::unexpected(done.error());
  }
  const auto again = read_recording(whole);
  if (!again) {
    return tl::unexpected(again.error());
  }
  if (!quiet) {
    fmt::print("{}The recording is in {}.\n", preview, whole.string());
  }
  return 0;
}

void ImportRequest::add_to(CLI::App& parser) {
  parser.add_option("file", input, "a text table, or a PC-DMIS text report")->required()->type_name("FILE");
  parser.add_option("-o,--output", folder, "folder for readings.csv and recording.toml; else a preview alone")
      ->type_name("FOLDER");
  parser.add_option("--format", format, "what the file is; auto looks into it")
      ->check(CLI::IsMember({"auto", "text", "pc-dmis"}));
  parser
      .add_option("--columns", columns,
                  "what the columns hold, from the first on: name,x,y,z (- passes over one), or name=1,x=5,y=6,z=7")
      ->type_name("NAMES");
  parser.add_option("--separator", separator, "between columns; by default the first row decides")
      ->check(CLI::IsMember({"semicolon", "tab", "comma", "blank"}));
  parser.add_option("--skip", skip, "lines above the table")->check(CLI::Range(0, 1'000'000))->type_name("N");
  parser.add_option("--unit", unit, "of lengths: mm, um, m or in")->type_name("UNIT");
  parser.add_option("--joint-unit", joint_unit, "of joint angles: deg, rad, mrad or arcsec")->type_name("UNIT");
  parser.add_option("--artefact", artefact, "artefact.toml that the recording names")->type_name("FILE");
  parser.add_option("--arm", arm, "arm.toml that the recording names, for joint angles")->type_name("ARM");
  parser.add_option("--probe-radius", probe_radius, "of the tip that took coordinates, such as \"3 mm\"")
      ->type_name("TEXT");
  parser.add_flag("--quiet,-q", quiet, "print nothing but errors");
  parser.footer(
      "Examples:\n  artcal import points.txt\n  artcal import points.txt --columns name,x,y,z --unit mm -o monday");
}

}  // namespace artcal
