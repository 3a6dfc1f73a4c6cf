// Which program this is.
#pragma once

namespace trace {

// "trace 0.1.0 (Release, g++ 12.2.0)"; TRACE_VERSION and TRACE_BUILD_TYPE are defined for these sources.
inline constexpr const char* version_text = "trace " TRACE_VERSION " (" TRACE_BUILD_TYPE
                                            ", "
#if defined(__clang__)
                                            "clang " __clang_version__ ")";
#else
                                            "g++ " __VERSION__ ")";
#endif

}  // namespace trace
