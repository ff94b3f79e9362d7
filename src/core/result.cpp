#include "cdfr/core/result.h"

namespace cdfr {

const char* code_text(Code code) noexcept {
  switch (code) {
    case Code::bad_option:
      return "bad option";
    case Code::empty_mesh:
      return "empty mesh";
    case Code::bad_index:
      return "bad index";
    case Code::not_finite:
      return "not finite";
    case Code::out_of_range:
      return "out of range";
    case Code::file_open:
      return "cannot open";
    case Code::file_format:
      return "bad format";
    case Code::file_version:
      return "unknown version";
    case Code::file_truncated:
      return "truncated";
    case Code::file_write:
      return "cannot write";
    case Code::cancelled:
      return "cancelled";
    case Code::not_closed:
      return "not closed";
  }
  return "unknown code";
}

}  // namespace cdfr
