#include "common/petsc/petsc.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "common/errors.hpp"

namespace pennon::petsc {

void check(PetscErrorCode code, const char* file, int line) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw SolverError(fmt::format("PETSc: {} ({}:{})", text ? text : "unknown error",
                                std::filesystem::path(file).filename().string(), line));
}

Session::Session() {
  // Signals are the program's own affair: PETSc would take the place of what it does at one, and
  // leave none behind.
  check(PetscOptionsSetValue(nullptr, "-no_signal_handler", "true"));
  check(PetscInitializeNoArguments());
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
}

Session::~Session() {
  PetscFinalize();
}

void start() {
  static const Session session;
}

}  // namespace pennon::petsc
