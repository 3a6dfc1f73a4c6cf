// Text from outside (file names, messages) made fit for formats that take only valid UTF-8.
#pragma once

#include <string>
#include <string_view>

namespace trace {

// Bytes that are not UTF-8 become U+FFFD.
std::string valid_utf8(std::string_view text);

// The same for XML 1.0, which has no control characters but tab, line feed and carriage return, and neither
// U+FFFE nor U+FFFF: these are dropped.
std::string xml_text(std::string_view text);

}  // namespace trace
