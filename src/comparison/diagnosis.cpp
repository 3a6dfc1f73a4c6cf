#include "comparison/diagnosis.hpp"

namespace trace {

std::string_view name(Diagnosis::Kind kind) {
  switch (kind) {
    case Diagnosis::Kind::shifted:
      return "shifted";
    case Diagnosis::Kind::flipped:
      return "flipped";
    case Diagnosis::Kind::channels_swapped:
      return "channels-swapped";
    case Diagnosis::Kind::gamma:
      return "gamma";
    case Diagnosis::Kind::brightness:
      return "brightness";
    case Diagnosis::Kind::shadows_missing:
      return "shadows-missing";
    case Diagnosis::Kind::reflection_missing:
      return "reflection-missing";
    case Diagnosis::Kind::object_missing:
      return "object-missing";
    case Diagnosis::Kind::object_displaced:
      return "object-displaced";
    case Diagnosis::Kind::edges:
      return "edges";
  }
  return "";
}

}  // namespace trace
