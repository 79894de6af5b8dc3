#include "app/manual_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/declared.hpp"

namespace pennon::app {
namespace {

// As text of man(7): a hyphen that may be copied, no letter that begins a request.
std::string escaped(const std::string& text) {
  std::string page;
  for (const char letter : text) {
    if (letter == '\\')
      page += "\\e";
    else if (letter == '-')
      page += "\\-";
    else if ((letter == '.' || letter == '\'') && (page.empty() || page.back() == '\n'))
      page += fmt::format("\\&{}", letter);
    else
      page += letter;
  }
  return page;
}

// "CASE" or "--set VALUE", "-h, --help".
std::string heading_of(const CLI::Option& option) {
  std::string names;
  const auto add = [&names](const std::string& name) {
    if (!names.empty()) names += ", ";
    names += name;
  };
  for (const std::string& name : option.get_snames()) add("-" + name);
  for (const std::string& name : option.get_lnames()) add("--" + name);
  if (names.empty()) return option.get_name();
  return option.get_expected_max() == 0 ? names : names + " VALUE";
}

std::string options_of(const CLI::App& command) {
  std::string page;
  for (const CLI::Option* option : command.get_options())
    page += fmt::format(".TP\n.B {}\n{}\n", escaped(heading_of(*option)),
                        escaped(option->get_description()));
  return page;
}

std::string upper_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) {
    return static_cast<char>(std::toupper(letter));
  });
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& program, const std::string& version) {
  const std::string& name = program.get_name();
  std::string page = fmt::format(
      ".TH {} 1 \"\" \"{} {}\"\n"
      ".SH NAME\n{} \\- the flutter of flags and thin membranes in a stream\n"
      ".SH SYNOPSIS\n.B {}\n.I COMMAND\n[options]\n"
      ".SH OPTIONS\n{}.SH COMMANDS\n",
      upper_case(name), name, version, name, name, options_of(program));
  for (const CLI::App* command : shown_commands(program))
    page += fmt::format(".SS {} {}\n{}.\n{}.PP\n{}\n", name, command->get_name(),
                        escaped(command->get_description()), options_of(*command),
                        escaped(command->get_footer()));
  page +=
      ".SH EXIT STATUS\n"
      ".TP\n.B 0\ndone\n"
      ".TP\n.B 1\nanything that is none of the others, an interrupt for example\n"
      ".TP\n.B 2\nthe input is at fault\n"
      ".TP\n.B 3\na solver did not converge, or a simulation blew up\n";
  return page;
}

}  // namespace pennon::app
