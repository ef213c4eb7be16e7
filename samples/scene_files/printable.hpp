// Text of files and command lines, made fit to be shown.
#pragma once

#include <string>
#include <string_view>

namespace islet::samples {

/// The same text as sound UTF-8 that XML, HTML and a terminal take as text: control characters become spaces; bytes that are no UTF-8 and code points that
/// are no characters (U+FFFE, U+FFFF and their like) become U+FFFD.
std::string printable(std::string_view text);

/// printable(text) for XML and HTML, between tags: &, < and > are written as entities.
std::string markup(std::string_view text);

}  // namespace islet::samples
