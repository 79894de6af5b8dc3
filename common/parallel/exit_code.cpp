#include "common/parallel/exit_code.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "common/utf8.hpp"

namespace pennon {
namespace {

void say_as_it_is(const std::string& text) {
  if (ranks::is_leading()) fmt::print(stderr, "{}\n", printable(text));
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
    fmt::print(stderr, "pennon: {}\n", printable(fault.what()));
    if (ranks::count() > 1) ranks::abandon(exit_other);
    return exit_other;
  }
}

}  // namespace pennon
