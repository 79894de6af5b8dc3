/// Standard input, output and error of a program that was started with some of them closed.
#pragma once

namespace pennon {

/// Keeps the numbers 0, 1 and 2 for the standard streams: without it the first file that is opened
/// takes a free one, and what is printed goes into that file. What is printed into a closed stream
/// fails then. To be called before any file is opened.
void keep_standard_streams();

}  // namespace pennon
