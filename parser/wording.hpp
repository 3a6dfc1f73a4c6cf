// How messages call the things of a scene.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/frames.hpp"
#include "parser/token.hpp"

namespace trace::parser {

std::string_view text_of(const Source& source, Span span);

// A token that was found: 'word', the string "name", the end of the file.
std::string found_text(const Source& source, const Token& token);

// A block with its article: "a sphere", "an ambient_light", "the camera", "a group", "the scene".
std::string block_text(const Source& source, const Frame& frame);
// The bare word: "sphere", "group", "material".
std::string block_word(const Source& source, const Frame& frame);

// "a", "a and b", "a, b and c"; with "or" likewise.
std::string enumeration(const std::vector<std::string>& parts, std::string_view last_joint);

// A kind of token that was expected: a number, a name, '{', 'true'.
std::string expected_text(Kind kind);
// All of them, joined by "or"; a name stands for a name in quotes too.
std::string expected_text(const std::vector<Kind>& kinds);

// "a sphere takes material and name"
std::string takes_text(const Source& source, const Frame& frame);
// "the objects are sphere, box, ... and height_field"
std::string objects_text();

}  // namespace trace::parser
