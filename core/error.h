#pragma once

#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

namespace artcal {

/// What went wrong, as a caller has to determine the cases apart. The values are the exit codes of the
/// program, so that a script and a library caller see the same distinction.
enum class ErrorCode {
  Usage = 2,       ///< the request itself is wrong: an unknown parameter name, a contradictory option
  BadInput = 3,    ///< a file cannot be read or says something impossible; nothing was computed
  NoSolution = 4,  ///< the input is sound, but the readings do not determine what was asked for
};

/// Errors of one code on which a caller acts differently. Nobody decides by a message.
enum class ErrorKind {
  Other,
  MissingFile,    ///< BadInput: there is no file of the name in `where`
  Misfit,         ///< NoSolution: no parameters fit the observations
  NoConvergence,  ///< NoSolution: an estimation ended before its minimum
};

/// Bad data, as a value. `where` is "file:line:column" as far as it is known, else empty; `message`
/// is one sentence: what was found, what was expected, what to do.
struct Error {
  ErrorCode code = ErrorCode::BadInput;
  std::string message;
  std::string where;
  ErrorKind kind = ErrorKind::Other;
  std::string found = {};   ///< the beginning of a message that ends with what to do; empty: it does not
  std::string reason = {};  ///< the most telling one of a message that gives several; empty: it gives one

  /// "where: message", the line a person reads: one line, even where a file's name holds a line end.
  [[nodiscard]] std::string text() const {
    std::string line = where.empty() ? message : where + ": " + message;
    for (char& c : line) {
      c = static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    }
    return line;
  }
};

template <typename T>
using Expected = tl::expected<T, Error>;

inline tl::unexpected<Error> bad_input(std::string message, std::string where = {}) {
  return tl::unexpected(Error{ErrorCode::BadInput, std::move(message), std::move(where)});
}
inline tl::unexpected<Error> wrong_usage(std::string message) {
  return tl::unexpected(Error{ErrorCode::Usage, std::move(message), {}});
}
inline tl::unexpected<Error> no_solution(std::string message, ErrorKind kind = ErrorKind::Other) {
  return tl::unexpected(Error{ErrorCode::NoSolution, std::move(message), {}, kind});
}
inline tl::unexpected<Error> no_convergence(std::string message) {
  return no_solution(std::move(message), ErrorKind::NoConvergence);
}

/// An error whose message also names what looks wrong in the input, since the cause may be there. A wrong request stays
/// as it is.
inline Error with_warnings(Error error, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (error.code != ErrorCode::Usage) {
      error.message += "; warning: " + warning;
    }
  }
  return error;
}

}  // namespace artcal
