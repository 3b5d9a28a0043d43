#pragma once

#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal::testing {

/// What a browser made of a page.
struct Opened {
  std::string document;                 ///< after every script has run
  std::vector<std::string> complaints;  ///< of its console
};

/// Pages in a Chromium without a window. Nothing of it stays: its profile is in the test's own folder.
template <typename Base>
class Browsing : public Base {
 protected:
  /// On a screen so high that every figure is in view, but where `options` have a size of their own.
  /// REQUIRES: Chromium is installed (cmake/packages.txt).
  [[nodiscard]] Opened open(const std::string& page, const std::vector<std::string>& options = {}) const {
    return open_url("file://" + this->file(page).string(), options);
  }
  [[nodiscard]] Opened open_url(const std::string& url, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"--dump-dom", "--window-size=900,30000"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended ended = chromium(arguments, url);
    Opened opened{ended.out, {}};
    // What it says of its own speed is no complaint about the page.
    static const std::regex own("Canvas2D: Multiple readback|GL Driver Message");
    static const std::regex console("CONSOLE[:(].*");
    for (auto line = std::sregex_iterator(ended.err.begin(), ended.err.end(), console); line != std::sregex_iterator();
         ++line) {
      if (!std::regex_search(line->str(), own)) {
        opened.complaints.push_back(line->str());
      }
    }
    return opened;
  }

  /// What of the elements that match `selector` lies to the left or right of a screen of that width, and words that are
  /// broken inside: {"shown": …, "beyond": …, "broken": …, "wider": whether the page scrolls sideways}.
  [[nodiscard]] nlohmann::json layout(const std::string& page, const std::string& selector, int width) const {
    std::ofstream(this->file("frame.html"))
        << "<body style=\"margin:0\"><iframe id=\"f\" style=\"border:0;height:2000px;width:" << width << "px\" src=\""
        << page << R"js("></iframe><p id="found"></p><script>
      document.getElementById('f').addEventListener('load', function () {
        const inside = this.contentDocument;
        const found = {shown: 0, beyond: 0, broken: 0};
        for (const table of inside.querySelectorAll('.table')) table.style.contentVisibility = 'visible';
        for (const one of inside.querySelectorAll(')js"
        << selector << R"js(')) {
          const {left, right, width} = one.getBoundingClientRect();
          found.shown += width > 0;
          found.beyond += left < 0 || right > )js"
        << width << R"js( || right > one.closest('.table').getBoundingClientRect().right + 1;
          const texts = inside.createTreeWalker(one, NodeFilter.SHOW_TEXT);
          for (let text; (text = texts.nextNode());) {
            for (const word of text.data.matchAll(/[^\s]{1,28}/g)) {
              const range = inside.createRange();
              range.setStart(text, word.index);
              range.setEnd(text, word.index + word[0].length);
              found.broken += new Set(Array.from(range.getClientRects(), ({top}) => Math.round(top))).size > 1;
            }
          }
        }
        found.wider = inside.documentElement.scrollWidth > )js"
        << width << R"js(;
        document.getElementById('found').textContent = JSON.stringify(found);
      });</script></body>)js";
    const Opened opened = open("frame.html", {"--allow-file-access-from-files"});
    std::smatch found;
    EXPECT_TRUE(std::regex_search(opened.document, found, std::regex("<p id=\"found\">([^<]+)</p>")))
        << opened.document;
    return nlohmann::json::parse(found[1].str());
  }

  /// Prints a page and returns pdfinfo's words about the PDF.
  [[nodiscard]] std::string print(const std::string& page) const {
    const std::string pdf = this->file("printed.pdf").string();
    const Ended ended =
        chromium({"--no-pdf-header-footer", "--print-to-pdf=" + pdf}, "file://" + this->file(page).string());
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return this->run_command({"pdfinfo", pdf}).out;
  }
  /// The text on the pages of the PDF that was printed last.
  [[nodiscard]] std::string printed_text() const {
    return this->run_command({"pdftotext", "-layout", this->file("printed.pdf").string(), "-"}).out;
  }

 private:
  [[nodiscard]] Ended chromium(std::vector<std::string> arguments, const std::string& url) const {
    arguments.insert(arguments.begin(),
                     {"timeout", "120", "chromium", "--headless", "--no-sandbox", "--disable-dev-shm-usage",
                      "--enable-unsafe-swiftshader", "--host-resolver-rules=MAP * ~NOTFOUND", "--hide-scrollbars",
                      "--window-size=900,1200", "--virtual-time-budget=20000", "--enable-logging=stderr",
                      "--user-data-dir=" + this->folder("browser").string()});
    arguments.push_back(url);
    return this->run_command(arguments);
  }
};

using BrowserTest = Browsing<ProgramTest>;

}  // namespace artcal::testing
