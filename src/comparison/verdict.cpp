#include "comparison/judge.hpp"

namespace trace {

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::identical:
      return "identical";
    case Verdict::within:
      return "within";
    case Verdict::beyond:
      return "beyond";
    case Verdict::not_finite:
      return "not-finite";
    case Verdict::size_differs:
      return "size-differs";
    case Verdict::channels_differ:
      return "channels-differ";
    case Verdict::unreadable:
      return "unreadable";
    case Verdict::missing:
      return "missing";
    case Verdict::extra:
      return "extra";
  }
  return "";
}

int exit_status(Verdict verdict) {
  switch (verdict) {
    case Verdict::identical:
    case Verdict::within:
      return 0;
    case Verdict::beyond:
    case Verdict::not_finite:
      return 1;
    case Verdict::size_differs:
    case Verdict::channels_differ:
      return 2;
    case Verdict::unreadable:
    case Verdict::missing:
    case Verdict::extra:
      break;
  }
  return 3;
}

}  // namespace trace
