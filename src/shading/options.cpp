#include "shading/options.hpp"

namespace trace {

std::string_view name_of(TransmissiveShadows rule) {
  switch (rule) {
    case TransmissiveShadows::distance:
      return "distance";
    case TransmissiveShadows::surface:
      return "surface";
    case TransmissiveShadows::none:
      break;
  }
  return "none";
}

std::optional<TransmissiveShadows> transmissive_shadows_named(std::string_view name) {
  for (const auto rule :
       {TransmissiveShadows::distance, TransmissiveShadows::surface, TransmissiveShadows::none}) {
    if (name == name_of(rule)) return rule;
  }
  return std::nullopt;
}

}  // namespace trace
