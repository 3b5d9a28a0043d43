#include "app/shell/manual_page.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/shell/help_text.h"

namespace artcal {
namespace {

// A line that begins with a dot or an apostrophe would be a request; a bare hyphen may become a dash.
std::string roff_escaped(std::string_view text) {
  std::string roff;
  for (const char c : text) {
    if (c == '\\') {
      roff += "\\e";
    } else if (c == '-') {
      roff += "\\-";
    } else {
      roff += c;
    }
  }
  return roff.starts_with('.') || roff.starts_with('\'') ? "\\&" + roff : roff;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string entries(const std::string& title, const std::vector<OptionDescription>& options) {
  std::string page = options.empty() ? "" : ".SH " + title + "\n";
  for (const OptionDescription& option : options) {
    page += fmt::format(".TP\n.B {}\n{}\n", roff_escaped(heading(option)), roff_escaped(option.full_text()));
  }
  return page;
}

std::string examples(const std::vector<std::string>& lines) {
  std::string page = lines.empty() ? "" : ".SH EXAMPLES\n.nf\n";
  for (const std::string& line : lines) {
    page += roff_escaped(line) + "\n";
  }
  return lines.empty() ? page : page + ".fi\n";
}

std::string commands(const CommandDescription& command) {
  std::string page = command.commands.empty() ? "" : ".SH COMMANDS\n";
  const bool is_program = command.path.size() == 1;
  for (const CommandDescription& inside : command.commands) {
    page += fmt::format(".TP\n.B {}\n{}\n", roff_escaped(is_program ? inside.path.back() : inside.usage()),
                        roff_escaped(inside.summary));
    if (is_program) {
      continue;
    }
    for (const auto* options : {&inside.arguments, &inside.options}) {
      for (const OptionDescription& option : *options) {
        page +=
            fmt::format(".RS\n.TP\n.B {}\n{}\n.RE\n", roff_escaped(heading(option)), roff_escaped(option.full_text()));
      }
    }
  }
  return page;
}

constexpr std::string_view exit_status = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
done, and conformity was not shown
.TP
.B 2
wrong usage
.TP
.B 3
an input was refused; the sentence on standard error names the place
.TP
.B 4
the input is sound, but there is no solution
.TP
.B 130
interrupted by Ctrl\-C
)";

std::string see_also(const CommandDescription& command) {
  if (command.path.size() > 1) {
    return ".SH SEE ALSO\n.BR artcal (1)\n";
  }
  std::vector<std::string> pages;
  for (const CommandDescription& inside : command.commands) {
    pages.push_back(fmt::format(".BR {} (1)", roff_escaped(manual_name(inside))));
  }
  return fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, ",\n"));
}

}  // namespace

std::string manual_name(const CommandDescription& command) { return fmt::format("{}", fmt::join(command.path, "-")); }

std::string manual_page(const CommandDescription& command, std::string_view version) {
  const Footer footer = parse_footer(command.footer);
  std::string page =
      fmt::format(".TH {} 1 \"\" \"artcal {}\" \"User Commands\"\n", upper(manual_name(command)), version);
  page += fmt::format(".SH NAME\n{} \\- {}\n", roff_escaped(manual_name(command)), roff_escaped(command.summary));
  page += fmt::format(".SH SYNOPSIS\n.B {}\n", roff_escaped(command.usage()));
  if (!footer.prose.empty()) {
    page += fmt::format(".SH DESCRIPTION\n{}\n", roff_escaped(footer.prose));
  }
  page += entries("ARGUMENTS", command.arguments) + commands(command) + entries("OPTIONS", command.options);
  page += std::string(exit_status) + examples(footer.examples) + see_also(command);
  return page;
}

}  // namespace artcal
