#include "app/case_notes.hpp"

#include <algorithm>

namespace pennon::app {
namespace {

using Notes = std::vector<std::string>;

bool has_nonzero(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return value != 0; });
}

// A displacement at the start, of any kind.
bool is_displaced(const dns::InitialSettings& initial) {
  return has_nonzero(initial.A) || has_nonzero(initial.B) || initial.angle != 0 ||
         initial.plate_mode != 0 || initial.mode_amplitude != 0 || !initial.global_modes.empty();
}

void add_local_notes(const Case& the_case, Notes& notes) {
  if (the_case.flag.leading_edge == LeadingEdge::clamped)
    notes.emplace_back(
        "flag.leading_edge = \"clamped\" has no effect here: the waves of the local theory know no "
        "edges");
}

void add_modes_notes(const Case& the_case, Notes& notes) {
  if (the_case.modes.family == modes::Family::in_vacuo) return;
  if (the_case.flag.leading_edge == LeadingEdge::clamped)
    notes.emplace_back(
        "flag.leading_edge = \"clamped\" and flag.K_B have no effect on the families bessel and "
        "hanging_chain, which are of membranes; modes.normal.family = \"in_vacuo\" has both");
  if (!the_case.has_flow)
    notes.emplace_back(
        "without [flow] no friction pulls the flag along its chord, so that the families "
        "bessel and hanging_chain have omega = 0");
}

void add_flow_notes(const Case& the_case, Notes& notes) {
  const dns::InitialSettings& initial = the_case.dns.initial;
  if (the_case.dns.motion.is_given) {
    if (is_displaced(initial) || initial.kick != 0 || initial.release != 0)
      notes.emplace_back(
          "[dns.initial] has no effect but for ramp: the flag moves as [dns.motion] says");
    return;
  }
  if (!is_displaced(initial) && initial.kick == 0 &&
      !has_nonzero({the_case.flag.gravity.begin(), the_case.flag.gravity.end()}))
    notes.emplace_back(
        "the flag starts flat and nothing disturbs it: what grows does so from rounding; "
        "dns.initial gives it a start");
}

void add_flag_notes(const Case& the_case, Notes& notes) {
  const std::array<double, 3>& gravity = the_case.flag.gravity;
  if (!is_displaced(the_case.dns.initial) && !the_case.dns.loads.are_there() &&
      !has_nonzero({gravity.begin(), gravity.end()}))
    notes.emplace_back(
        "the flag starts at rest and nothing acts on it: it stays there; [dns.initial], "
        "[dns.loads] or flag.gravity move it");
}

}  // namespace

std::vector<std::string> notes_on(const Case& the_case, const std::string& command) {
  Notes notes;
  if (command == "lsa") add_local_notes(the_case, notes);
  if (command == "modes") add_modes_notes(the_case, notes);
  if (command == "dns" && the_case.has_flow) add_flow_notes(the_case, notes);
  if (command == "dns" && !the_case.has_flow) add_flag_notes(the_case, notes);
  return notes;
}

}  // namespace pennon::app
