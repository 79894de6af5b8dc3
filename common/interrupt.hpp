/// Signals that ask pennon to stop: long work looks now and then whether one has come, and leaves
/// with its files whole.
#pragma once

namespace pennon {

/// From now on these signals only note that the run is to stop:
///
///   SIGINT             Ctrl-C; a second one ends the process at once
///   SIGTERM            kill, mpiexec when it is stopped itself, and queues
///   SIGUSR1, SIGUSR2   queues, as a warning before the time is over
///   SIGHUP             a terminal that was closed; not under nohup
void watch_for_interrupts();

/// Whether one of them has come.
bool is_interrupted();

/// Whether the first that came did so longer ago than that.
bool was_interrupted_before(double seconds);

/// Throws Interrupted, with the signal's name and `advice` on how to go on, if one has come.
void stop_if_interrupted(const char* advice);

}  // namespace pennon
