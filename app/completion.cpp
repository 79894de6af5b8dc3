#include "app/completion.hpp"

#include <fmt/format.h>

#include "app/declared.hpp"

namespace pennon::app {
namespace {

// The words of an App: --help --version lsa modes ...
std::string words_of(const CLI::App& command) {
  std::string words;
  const auto add = [&words](const std::string& word) {
    if (!words.empty()) words += ' ';
    words += word;
  };
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) add("--" + name);
  for (const CLI::App* inner : shown_commands(command)) add(inner->get_name());
  return words;
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string cases = fmt::format("    '') words='{}' ;;\n", words_of(program));
  for (const CLI::App* command : shown_commands(program))
    cases += fmt::format("    {}) words='{}' ;;\n", command->get_name(), words_of(*command));
  return fmt::format(R"(# Completion of the words of {0} for bash, made by `{0} completion`.
_{0}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} command='' words='' i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ ${{COMP_WORDS[i]}} != -* ]]; then
      command=${{COMP_WORDS[i]}}
      break
    fi
  done
  case $command in
{1}  esac
  if [[ -z $command || $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
    compopt -o filenames 2>/dev/null
  fi
}}
complete -F _{0} {0}
)",
                     program.get_name(), cases);
}

}  // namespace pennon::app
