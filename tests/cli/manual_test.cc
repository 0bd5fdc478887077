// Tests of the man pages that the program makes from its help texts (app/manual_page.h).

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/command.h"

namespace mjforge {
namespace {

class ManualTest : public harness::ProgramTest {
 protected:
  ManualTest() {
    std::filesystem::create_directory(folder() / "man");
    REQUIRE(Run({"__man", "man"}).status == 0);
  }

  // Returns the formatted page, 80 columns wide. Fails the test if groff reports a problem.
  std::string Read(const std::string& page) const {
    const harness::Command groff{.program = "groff",
                                 .arguments = {"-man", "-ww", "-Tascii", "-P-cbou", "man/" + page},
                                 .environment = {{"GROFF_NO_SGR", "1"}},
                                 .folder = folder().path()};
    const harness::CommandResult result = groff.Run();
    CHECK(result.status == 0);
    CHECK(result.err.empty());
    return result.out;
  }
};

TEST_CASE_METHOD(ManualTest, "there is a man page for each command, and groff reads all of them") {
  const std::string first = Read("mjforge.1");
  std::vector<std::string> files;
  const std::string help = Run({"--help"}).out;
  std::size_t line = help.find("Subcommands:\n") + 13;
  while (help.compare(line, 2, "  ") == 0) {
    const std::size_t begin = line + 2;
    const std::string name = help.substr(begin, help.find(' ', begin) - begin);
    files.push_back("man/mjforge-" + name + ".1");
    INFO(name);
    const std::string page = Read("mjforge-" + name + ".1");
    CHECK(page.find("\nNAME\n       mjforge-" + name + " - ") != std::string::npos);
    CHECK(page.find("\nSYNOPSIS\n       mjforge " + name + " [OPTIONS]") != std::string::npos);
    CHECK(page.find("\nEXAMPLES\n       ") != std::string::npos);
    CHECK(first.find("mjforge-" + name + "(1)") != std::string::npos);
    line = help.find('\n', line) + 1;
  }
  files.push_back("man/mjforge.1");
  std::sort(files.begin(), files.end());
  CHECK(files.size() == 13);
  CHECK(folder().Files() == files);
}

TEST_CASE_METHOD(ManualTest, "every option of the help is on the page, with what the help says") {
  const std::string help = Run({"generate", "--help"}).out;
  const std::string page = Read("mjforge-generate.1");
  std::size_t line = help.find("\nOptions:\n") + 10;
  int count = 0;
  while (help.compare(line, 3, "  -") == 0) {
    const std::size_t end = help.find('\n', line);
    const std::size_t gap = help.find("  ", line + 2);
    std::string names = help.substr(line + 2, gap - line - 2);
    if (names.starts_with("-") && names[2] == ',') names.insert(3, " ");
    const std::string doc = help.substr(help.find_first_not_of(' ', gap), end);
    INFO(names);
    CHECK(page.find("\n       " + names) != std::string::npos);
    CHECK(page.find(doc.substr(0, doc.find('\n'))) != std::string::npos);
    line = end + 1;
    ++count;
  }
  CHECK(count >= 30);
}

TEST_CASE_METHOD(ManualTest, "examples and quotes come out as they are typed") {
  CHECK(Read("mjforge-generate.1")
            .find("\n       mjforge generate hammer -n 100 --set 'handle_length=10cm .. 12cm' -o "
                  "out/\n") != std::string::npos);
  CHECK(Read("mjforge-catalogue.1").find("\n       MJFORGE_PATH=~/my-specs mjforge catalogue") !=
        std::string::npos);
}

TEST_CASE_METHOD(ManualTest, "the pages are the same in each build: they have no date") {
  CHECK(folder().Read("man/mjforge.1").starts_with(".TH MJFORGE 1 \"\" \"mjforge "));
}

TEST_CASE_METHOD(ManualTest, "a folder that is not there is an error") {
  const auto result = Run({"__man", "nosuch"});
  CHECK(result.status == 3);
  CHECK(result.err.find("nosuch/mjforge.1") != std::string::npos);
}

}  // namespace
}  // namespace mjforge
