#pragma once
#include <cstdlib>
#define UWX(name, d)                                                                                \
  ([]() -> double {                                                                                 \
    static const double uwx_value = std::getenv("U_" name) ? std::atof(std::getenv("U_" name)) : d; \
    return uwx_value;                                                                               \
  }())
