#include "common/parallel/exit_code.hpp"

#include <cstdio>
#include <exception>
#include <string>

#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "common/utf8.hpp"

namespace pennon {
namespace {

// Nothing more can be said where standard error cannot be written.
void write_line(const std::string& text) {
  const std::string line = printable(text) + "\n";
  (void)std::fwrite(line.data(), 1, line.size(), stderr);
}

void say_as_it_is(const std::string& text) {
  if (ranks::is_leading()) write_line(text);
}

}  // namespace

void say(const std::string& text) {
  say_as_it_is("pennon: " + text);
}

int exit_code_of(const std::function<int()>& program) {
  try {
    return program();
  } catch (const InputError& fault) {
    say_as_it_is(fault.what());
    return exit_bad_input;
  } catch (const SolverError& fault) {
    say(fault.what());
    return exit_not_converged;
  } catch (const Interrupted& stop) {
    say(stop.what());
    return exit_other;
  } catch (const std::exception& fault) {
    write_line(std::string("pennon: ") + fault.what());
    if (ranks::count() > 1) ranks::abandon(exit_other);
    return exit_other;
  }
}

}  // namespace pennon
