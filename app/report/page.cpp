#include "app/report/page.h"

#include <cctype>

#include <openssl/evp.h>
#include <openssl/sha.h>

#include <fmt/format.h>

#include "app/report/html.h"
#include "app/report/web_files.h"
#include "app/version.h"
#include "core/files/hash.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// As a Content-Security-Policy names a script.
std::string hash_source(std::string_view script) {
  unsigned char digest[SHA256_DIGEST_LENGTH];
  SHA256(reinterpret_cast<const unsigned char*>(script.data()), script.size(), digest);
  unsigned char base64[4 * ((SHA256_DIGEST_LENGTH + 2) / 3) + 1];
  const int length = EVP_EncodeBlock(base64, digest, SHA256_DIGEST_LENGTH);
  return fmt::format("'sha256-{}'", std::string_view(reinterpret_cast<const char*>(base64), length));
}

/// A script, how the policy names it, and the licence it comes under, if it is not ours.
struct Script {
  std::string_view code;
  std::string_view licence;
  std::string source;

  explicit Script(std::string_view text, std::string_view under = {})
      : code(text), licence(under), source(hash_source(text)) {}
};

// Their hashes are taken once: a batch writes many pages.
const std::vector<Script>& scripts_of(Scripts which) {
  static const std::vector<Script> plots{Script(web_files::plotly(), web_files::plotly_licence()),
                                         Script(web_files::figures())};
  static const std::vector<Script> missing{Script(web_files::missing())};
  static const std::vector<Script> sorting{Script(web_files::sorting())};
  return which == Scripts::Plots ? plots : which == Scripts::SharedPlots ? missing : sorting;
}

// As a string of CSS: only letters, digits and spaces stand as they are (the space behind an escape ends it), so that
// nothing ends the string or the style.
std::string css_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const bool is_plain =
        (static_cast<unsigned char>(c) & 0x80U) != 0 || std::isalnum(static_cast<unsigned char>(c)) != 0 || c == ' ';
    quoted += is_plain ? std::string(1, c) : fmt::format("\\{:x} ", static_cast<unsigned char>(c));
  }
  return quoted + "\"";
}

std::string running_style(const std::string& running) {
  return running.empty() ? ""
                         : fmt::format("@page {{ @bottom-left {{ content: {}; font: 9pt sans-serif; }} }}\n",
                                       css_string(truncated(80, running)));
}

}  // namespace

std::string page_html(const Page& page) {
  const auto& scripts = scripts_of(page.scripts);
  const bool shares = page.scripts == Scripts::SharedPlots;
  std::string sources = shares ? " 'self' file:" : "";
  std::string code = shares ? fmt::format("<script src=\"{}\"></script>\n", shared_scripts().name) : "";
  for (const Script& script : scripts) {
    sources += " " + script.source;
    code += script.licence.empty() ? "" : fmt::format("<!-- {} -->\n", script.licence);
    code += fmt::format("<script>{}</script>\n", script.code);
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src{}; "
      "style-src 'unsafe-inline'; img-src data: blob:; font-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"generator\" content=\"artcal {}\">\n<title>{}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n{}"
      "<script type=\"application/json\" id=\"data\">{}</script>\n{}</body>\n</html>\n",
      sources, program_version, html::text(page.title), web_files::style(), running_style(page.running), page.body,
      html::data(page.data), code);
}

const SharedScripts& shared_scripts() {
  static const SharedScripts scripts = [] {
    const std::string text = fmt::format("/* {} */\n{}\n(() => {{\n{}}})();\n", web_files::plotly_licence(),
                                         web_files::plotly(), web_files::figures());
    return SharedScripts{fmt::format("plots-{}.js", sha256(text).substr(0, 12)), text};
  }();
  return scripts;
}

}  // namespace artcal
