#include "app/stream/recording_folder.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/output.h"
#include "artefacts/artefact/artefact_file.h"
#include "core/files/size_limits.h"
#include "core/files/text_file.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_text.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

using Copy = std::pair<std::string, std::string>;  // name and text

Expected<void> add_copy(const fs::path& path, const std::string& name, std::vector<Copy>& copies) {
  const bool is_taken = std::any_of(copies.begin(), copies.end(), [&](const Copy& copy) { return copy.first == name; });
  if (is_taken || name == "recording.toml" || name == "readings.csv") {
    return bad_input(
        fmt::format("the file is called {}, as another file of the recording; give it another name", in_quotes(name)),
        path.string());
  }
  return read_text_file(path, largest::toml).map([&](TextFile&& file) {
    copies.emplace_back(name, std::move(file.text));
  });
}

Expected<std::vector<Copy>> copies_of(const RecordingBegin& begin, const FileAccess& access) {
  std::vector<Copy> copies;
  auto added = add_copy(begin.arm, "arm.toml", copies);
  for (const fs::path& path : begin.artefacts) {
    if (!added) {
      return tl::unexpected(added.error());
    }
    const auto artefact = read_artefact_file(path, access);
    if (!artefact) {
      return tl::unexpected(artefact.error());
    }
    added = add_copy(path, path.filename().string(), copies);
    if (added && artefact->certificate) {
      const fs::path certificate = artefact->certificate->path;
      if (artefact->certificate_name != certificate.filename().string()) {
        return bad_input(
            "the certificate named in `dcc` cannot be copied; put it into the artefact's folder and name it there",
            path.string());
      }
      added = add_copy(certificate, certificate.filename().string(), copies);
    }
  }
  return added ? Expected<std::vector<Copy>>(std::move(copies)) : tl::unexpected(added.error());
}

std::string recording_text(const RecordingBegin& begin) {
  std::vector<std::string> artefacts;
  for (const fs::path& path : begin.artefacts) {
    artefacts.push_back(toml_text(path.filename().string()));
  }
  const std::string name = fs::path(begin.folder / "").lexically_normal().parent_path().filename().string();
  return fmt::format(
      "# Written by artcal record.\nschema = \"artcal-recording/1\"\nname = {}\ndate = {}\narm = \"arm.toml\"\n"
      "artefacts = [{}]\nreadings = [\"readings.csv\"]\nunits = {{ joint = \"deg\", length = \"mm\" }}\n",
      toml_text(name.empty() || name == "." || name == ".." ? "recording" : name), begin.date,
      fmt::join(artefacts, ", "));
}

// A file of the folder: written where it is not there, else it has to be the same.
Expected<void> write_or_compare(const fs::path& path, const std::string& text) {
  if (!fs::exists(path)) {
    return write_file(path.string(), text);
  }
  const auto there = read_text_file(path, largest::toml);
  if (!there) {
    return tl::unexpected(there.error());
  }
  return there->text == text
             ? Expected<void>()
             : bad_input(
                   "the recording in this folder was begun with another file of this name; record into another "
                   "folder, or give the file that is here",
                   path.string());
}

}  // namespace

Expected<RowFile> begin_recording(const RecordingBegin& begin, const FileAccess& access, const std::string& header) {
  const auto copies = copies_of(begin, access);
  if (!copies) {
    return tl::unexpected(copies.error());
  }
  std::error_code error;
  fs::create_directories(begin.folder, error);
  if (error) {
    return bad_input(fmt::format("the folder cannot be made: {}", error.message()), begin.folder.string());
  }
  const fs::path recording = begin.folder / "recording.toml";
  const fs::path readings = begin.folder / "readings.csv";
  if (fs::exists(recording) && !fs::exists(readings)) {
    return bad_input("the folder has a recording that artcal record has not begun; record into another folder",
                     recording.string());
  }
  auto table = RowFile::open(readings, header);
  if (!table) {
    return table;
  }
  for (const auto& [name, text] : *copies) {
    if (auto written = write_or_compare(begin.folder / name, text); !written) {
      return tl::unexpected(written.error());
    }
  }
  if (!fs::exists(recording)) {
    if (auto written = write_file(recording.string(), recording_text(begin)); !written) {
      return tl::unexpected(written.error());
    }
  }
  return table;
}

}  // namespace artcal
