/// Standard input, output and error of a program that was started with some of them closed, or
/// whose reader goes away.
#pragma once

namespace pennon {

/// Keeps the numbers 0, 1 and 2 for the standard streams: without it the first file that is opened
/// takes a free one, and what is printed goes into that file. What is printed into a closed stream
/// fails then. What is printed into a pipe that nobody reads fails too, and does not end the
/// program by SIGPIPE. To be called before any file is opened.
void keep_standard_streams();

}  // namespace pennon
