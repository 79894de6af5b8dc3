/// Drawing at the end of a command, whose results stand whether it succeeds or not.
#pragma once

#include <functional>

namespace pennon::app {

/// Says on standard error that there will be no pictures where gnuplot is not installed.
void warn_without_gnuplot();

/// Calls `draw`. Where a picture cannot be drawn, says why on standard error and how to draw it
/// later, and returns; nothing is said twice where gnuplot is not installed.
void draw_pictures(const std::function<void()>& draw);

}  // namespace pennon::app
