// What reports say of how they came about.
#pragma once

#include <filesystem>
#include <string>

namespace trace {

// This moment: "2026-11-22T17:00:00Z".
std::string time_text();

// The last name of a folder or file, however it is written: "scenes" for "..", if that is its name.
std::string title_text(const std::filesystem::path& path);

}  // namespace trace
