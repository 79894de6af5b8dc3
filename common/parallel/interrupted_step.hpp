/// Leaving a step that takes long where a signal has asked pennon to stop: its solvers look now and
/// then, and whoever began the step goes back to the state before it. What comes to its end within
/// half a second of the signal is not left: a run that is being prepared then has a state to keep.
#pragma once

namespace pennon::ranks {

/// Throws Interrupted on all ranks where a signal reached one of them so long ago. Every rank
/// calls.
void stop_if_interrupted();

/// The same for work that each rank does by itself, where there is only this one; several would
/// have to agree first, and go on.
void stop_if_interrupted_alone();

}  // namespace pennon::ranks
