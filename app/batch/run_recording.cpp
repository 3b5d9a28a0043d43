#include "app/batch/run_recording.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "acquisition/recording/recording_file.h"
#include "app/batch/recording_key.h"
#include "app/batch/result_rows.h"
#include "app/output/phrases.h"
#include "app/requests/identify_request.h"
#include "app/requests/model_asked.h"
#include "app/results/identification/readings_json.h"
#include "app/results/identification/result_json.h"
#include "app/results/inspection/inspected_run.h"
#include "app/results/inspection/inspection_json.h"
#include "app/results/verification/verification_json.h"
#include "app/results/verification/verification_run.h"
#include "artefacts/constraints/bound_recording.h"
#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr int conformity_not_shown = 1;

/// A recording with all that it refers to, and the name of its result.
struct Job {
  Recording recording;
  Constraints constraints;                           ///< for an identification, where one is asked for
  std::optional<VerificationMaterial> verification;  ///< where one is asked for
  std::vector<InputFile> inputs;
  std::string key;

  [[nodiscard]] const Recording& whole() const { return verification ? verification->recording : recording; }
  [[nodiscard]] const Constraints& bound() const { return verification ? verification->constraints : constraints; }
};

// A result does not depend on where the recording lies, and so neither do its words.
void leave_out_folder(nlohmann::ordered_json& json, const std::filesystem::path& folder) {
  if (json.is_string()) {
    json = without_folder(json.get<std::string>(), folder);
  }
  if (json.is_structured()) {
    for (nlohmann::ordered_json& inner : json) {
      leave_out_folder(inner, folder);
    }
  }
}

constexpr std::string_view changed_meanwhile =
    "the file changed while the recording was being processed; run this again when nobody writes to it any more";

// Artefacts and scans are read for the identification and again for the verification: a file of both with two contents.
const InputFile* first_difference(const std::vector<InputFile>& one, const std::vector<InputFile>& other) {
  for (const InputFile& input : one) {
    const auto same =
        std::find_if(other.begin(), other.end(), [&](const auto& file) { return file.path == input.path; });
    if (same != other.end() && same->sha256 != input.sha256) {
      return &input;
    }
  }
  return nullptr;
}

Expected<Job> read_job(const std::filesystem::path& path, const BatchOptions& options) {
  auto recording = read_recording(path, options.access_of(path));
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  Job job{*recording, {}, {}, {}, {}};
  if (recording->identify.asked) {
    auto bound =
        bind_recording(*recording, options.access_of(path), {ScanUse::SureOfBall, nullptr, options.limits.max_memory});
    if (!bound) {
      return tl::unexpected(bound.error());
    }
    job.recording = std::move(bound->recording);
    job.constraints = std::move(bound->constraints);
  }
  if (!recording->verify.standard.empty()) {
    // A verification makes other readings of scans than an identification.
    auto material =
        read_verification_material(std::move(*recording), {"", "", options.access_of(path), options.limits});
    if (!material) {
      return tl::unexpected(material.error());
    }
    if (const auto* changed = first_difference(job.recording.inputs, material->recording.inputs)) {
      return bad_input(std::string(changed_meanwhile), changed->path);
    }
    job.verification = std::move(*material);
  }
  job.inputs = seen_from(path.parent_path(), job.whole().inputs);
  job.key = recording_key(job.inputs, job.whole().name, options);
  return job;
}

void note_error(RecordingOutcome& outcome, const Error& error) {
  outcome.exit_code = std::max(outcome.exit_code, static_cast<int>(error.code));
  outcome.error += (outcome.error.empty() ? "" : "; ") + truncated(largest::message, error.text());
}

void do_identify(RecordingOutcome& outcome, const Job& job, const BatchOptions& options, Keep keep) {
  IdentifyOptions asked = recorded_options(job.recording);
  asked.leave_out = options.leave_out;
  asked.threads = 1;
  const auto model = model_asked("", job.recording);
  if (!model) {
    note_error(outcome, model.error());
    return;
  }
  asked.model = model->groups;
  asked.automatic = model->automatic;
  const auto inspected =
      inspect_result(identify(job.recording, job.constraints, asked), job.recording, job.constraints, asked);
  const auto& result = inspected.result;
  if (!result) {
    note_error(outcome, result.error());
    return;
  }
  outcome.identified = true;
  add_identification(outcome.entry, job.key, *result);
  add_remarks(outcome.entry, job.key, "warning", result->warnings);
  if (keep == Keep::RowsAndResults) {
    auto json = to_json(job.recording, job.constraints, asked, *result, {});
    json["findings"] = findings_json(inspected.findings);
    json["residuals"] = residuals_json(job.recording, job.constraints, *result);
    outcome.results.push_back(reported(std::move(json)));
  }
}

void do_verify(RecordingOutcome& outcome, Job& job, Keep keep) {
  const auto result = run_verification(*job.verification, "", "");
  if (!result) {
    note_error(outcome, result.error());
    return;
  }
  outcome.verified = true;
  outcome.exit_code = std::max(outcome.exit_code, is_shown(*result) ? 0 : conformity_not_shown);
  add_verification(outcome.entry, job.key, *result, job.verification->specification.name);
  add_remarks(outcome.entry, job.key, "warning", result->verification.warnings);
  add_remarks(outcome.entry, job.key, "missing", result->verification.missing);
  add_remarks(outcome.entry, job.key, "waived", result->verification.waived);
  if (keep == Keep::RowsAndResults) {
    auto json = to_json(job.verification->session(), *result);
    json["findings"] = findings_json(findings_for_verification(
        job.verification->recording, job.verification->constraints, job.verification->session().arm));
    outcome.results.push_back(reported(std::move(json)));
  }
}

void finish_outcome(RecordingOutcome& outcome, const std::string& key, const std::filesystem::path& folder) {
  outcome.error = without_folder(outcome.error, folder);
  const StoreValue error = outcome.error.empty() ? StoreValue() : StoreValue(outcome.error);
  const StoreValue recording = key.empty() ? StoreValue() : StoreValue(key);
  const long long exit_code = outcome.exit_code;
  if (auto& rows = outcome.entry[StoreTable::Recordings]; !rows.empty()) {
    rows.front()[7] = exit_code;
    rows.front()[8] = error;
  }
  for (StoreRow& remark : outcome.entry[StoreTable::Remarks]) {
    remark[3] = without_folder(std::get<std::string>(remark[3]), folder);
  }
  for (ReportedResult& result : outcome.results) {
    leave_out_folder(result.json, folder);
  }
  outcome.entry[StoreTable::Files] = {{outcome.path, recording, exit_code, error}};
}

RecordingOutcome refused(const std::string& path, const Error& error) {
  RecordingOutcome outcome;
  outcome.path = path;
  note_error(outcome, error);
  finish_outcome(outcome, "", std::filesystem::path(path).parent_path());
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    outcome.entry = {};  // a path that was mistyped is nothing that a store should keep
  }
  return outcome;
}

RecordingOutcome known(const std::string& path, const std::string& key, const StoredResult& result) {
  RecordingOutcome outcome;
  outcome.path = path;
  outcome.exit_code = result.exit_code;
  outcome.error = result.error;
  outcome.was_known = true;
  finish_outcome(outcome, key, std::filesystem::path(path).parent_path());
  return outcome;
}

RecordingOutcome run(const std::string& path, const BatchOptions& options, const FindResult& find, Keep keep) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  auto job = read_job(path, options);
  if (!job) {
    return refused(path, job.error());
  }
  if (find) {
    if (const auto result = find(job->key)) {
      return known(path, job->key, *result);
    }
  }
  RecordingOutcome outcome;
  outcome.path = path;
  add_recording(outcome.entry, job->key, options.text(), job->whole(), job->bound(), job->inputs);
  if (job->recording.identify.asked) {
    do_identify(outcome, *job, options, keep);
  }
  if (job->verification) {
    do_verify(outcome, *job, keep);
  }
  if (const std::string changed = first_changed(folder, job->inputs); !changed.empty()) {
    return refused(path, {ErrorCode::BadInput, std::string(changed_meanwhile), changed});
  }
  finish_outcome(outcome, job->key, folder);
  return outcome;
}

}  // namespace

RecordingOutcome run_recording(const std::string& path, const BatchOptions& options, const FindResult& find,
                               Keep keep) {
  try {
    return run(path, options, find, keep);
  } catch (const std::bad_alloc&) {
    return refused(path, {ErrorCode::BadInput, "there is not enough memory for this recording", ""});
  } catch (const std::exception& error) {
    return refused(path, {ErrorCode::BadInput, text_of_exception(error), ""});
  }
}

std::optional<RecordingOutcome> known_outcome(const std::string& path, const StoredFile& file,
                                              const BatchOptions& options) {
  if (file.recording.empty()) {
    return std::nullopt;
  }
  const auto now = hashed_now(std::filesystem::path(path).parent_path(), file.inputs);
  if (now.empty() || recording_key(now, file.name, options) != file.recording) {
    return std::nullopt;
  }
  return known(path, file.recording, file.result);
}

}  // namespace artcal
