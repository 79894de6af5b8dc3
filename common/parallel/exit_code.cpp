#include "common/parallel/exit_code.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon {
namespace {

void say_once(const std::string& text) {
  if (ranks::is_leading()) fmt::print(stderr, "{}\n", text);
}

}  // namespace

int exit_code_of(const std::function<int()>& program) {
  try {
    return program();
  } catch (const InputError& fault) {
    say_once(fault.what());
    return exit_bad_input;
  } catch (const SolverError& fault) {
    say_once(fmt::format("pennon: {}", fault.what()));
    return exit_not_converged;
  } catch (const Interrupted& stop) {
    say_once(fmt::format("pennon: {}", stop.what()));
    return exit_other;
  } catch (const std::exception& fault) {
    fmt::print(stderr, "pennon: {}\n", fault.what());
    if (ranks::count() > 1) ranks::abandon(exit_other);
    return exit_other;
  }
}

}  // namespace pennon
