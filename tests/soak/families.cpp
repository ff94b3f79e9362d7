#include "soak/families.h"

#include <array>

namespace cdfr::soak {

std::span<const Family> families() {
  static constexpr std::array<Family, 14> all{{{"wedge", make_wedge},
                                               {"cap", make_cap},
                                               {"needle", make_needle},
                                               {"flat", make_flat},
                                               {"fan", make_fan},
                                               {"star", make_star},
                                               {"fins", make_fins},
                                               {"slots", make_slots},
                                               {"shells", make_shells},
                                               {"plate", make_plate},
                                               {"blocks", make_blocks},
                                               {"gear", make_gear},
                                               {"sphere", make_sphere},
                                               {"torus", make_torus}}};
  return all;
}

}  // namespace cdfr::soak
