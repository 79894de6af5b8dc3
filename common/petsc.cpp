#include "common/petsc.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "common/errors.hpp"

namespace pennon::petsc {

void check(PetscErrorCode code, const std::source_location& place) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw SolverError(fmt::format("PETSc: {} ({}:{})", text ? text : "unknown error",
                                std::filesystem::path(place.file_name()).filename().string(),
                                place.line()));
}

Session::Session() {
  check(PetscInitializeNoArguments());
  check(PetscPopSignalHandler());  // signals are the program's own affair
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
}

Session::~Session() {
  PetscFinalize();
}

void start() {
  static const Session session;
}

}  // namespace pennon::petsc
