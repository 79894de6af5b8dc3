/// PETSc's objects as C++ values, its error codes as exceptions.
#pragma once

#include <petscksp.h>

#include <exception>
#include <utility>

namespace pennon::petsc {

/// Throws SolverError with PETSc's words and the place of the call unless `code` says success.
void check(PetscErrorCode code, const char* file = __builtin_FILE(), int line = __builtin_LINE());

/// MPI and PETSc from construction to destruction; the first object of a program that needs them.
/// Reads PETSc's options from the environment variable PETSC_OPTIONS.
class Session {
 public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

/// Starts a session that lasts to the end of the program, unless there is one.
void start();

/// Owns a PETSc object; converts to it.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Handle {
 public:
  Handle() = default;
  Handle(Handle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (object_ && !PetscFinalizeCalled) destroy(&object_);
  }
  operator Object() const { return object_; }
  /// For the functions that create it.
  Object* address() { return &object_; }

 private:
  Object object_ = nullptr;
};

using Vector = Handle<Vec, VecDestroy>;
using Matrix = Handle<Mat, MatDestroy>;
using KrylovMethod = Handle<KSP, KSPDestroy>;

/// Runs a function inside a C callback, through which no exception may pass: an exception is kept
/// in `caught` and becomes an error code. The caller rethrows it once PETSc has returned.
template <class Function>
PetscErrorCode guarded(std::exception_ptr& caught, Function&& function) {
  try {
    function();
    return 0;
  } catch (...) {
    caught = std::current_exception();
    return PETSC_ERR_LIB;
  }
}

}  // namespace pennon::petsc
