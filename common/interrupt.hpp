/// Ctrl-C and SIGTERM: long work asks now and then whether to stop, and leaves with its files
/// whole.
#pragma once

namespace pennon {

/// From now on SIGINT and SIGTERM only note that the user wants to stop; a second one ends the
/// process at once.
void watch_for_interrupts();

/// Whether one of the two has come.
bool is_interrupted();

/// Throws Interrupted, with `advice` on how to go on, if one of the two has come.
void stop_if_interrupted(const char* advice);

}  // namespace pennon
