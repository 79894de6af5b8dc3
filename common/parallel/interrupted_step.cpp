#include "common/parallel/interrupted_step.hpp"

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::ranks {
namespace {

[[noreturn]] void stop() {
  pennon::stop_if_interrupted("what it was computing is not kept; start it again");
  throw Interrupted("stopped by another rank");
}

}  // namespace

void stop_if_interrupted() {
  if (any(is_interrupted())) stop();
}

void stop_if_interrupted_alone() {
  if (is_interrupted() && count() == 1) stop();
}

}  // namespace pennon::ranks
