#include "app/pictures.hpp"

#include <exception>
#include <string>

#include "common/errors.hpp"
#include "common/parallel/exit_code.hpp"
#include "common/process/process.hpp"

namespace pennon::app {
namespace {

bool has_gnuplot() {
  return find_program("gnuplot").has_value();
}

}  // namespace

void warn_without_gnuplot() {
  if (!has_gnuplot())
    say("there will be no pictures, because gnuplot was not found; install gnuplot-nox, and pennon "
        "plot draws them later");
}

void draw_pictures(const std::function<void()>& draw) {
  if (!has_gnuplot()) return;
  const auto say_why = [](const std::exception& fault) {
    say(std::string("the results are whole, but a picture was not drawn: ") + fault.what() +
        "; pennon plot draws it later");
  };
  try {
    draw();
  } catch (const FileError& fault) {
    say_why(fault);
  } catch (const InputError& fault) {
    say_why(fault);
  }
}

}  // namespace pennon::app
