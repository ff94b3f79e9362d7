/// All the families of made meshes.
#pragma once

#include <span>

#include "soak/shape.h"

namespace cdfr::soak {

std::span<const Family> families();

/// sharp.cpp: small dihedral angles, long needles, flat bodies.
Shape make_wedge(std::uint64_t round, test::Random& random);
Shape make_cap(std::uint64_t round, test::Random& random);
Shape make_needle(std::uint64_t round, test::Random& random);
Shape make_flat(std::uint64_t round, test::Random& random);

/// round.cpp: spheres, tori, spikes, shells in shells.
Shape make_sphere(std::uint64_t round, test::Random& random);
Shape make_torus(std::uint64_t round, test::Random& random);
Shape make_star(std::uint64_t round, test::Random& random);
Shape make_shells(std::uint64_t round, test::Random& random);

/// polar.cpp: vertices of high valence, extruded stars with slits and spikes.
Shape make_fan(std::uint64_t round, test::Random& random);
Shape make_gear(std::uint64_t round, test::Random& random);

/// blocks.cpp: unions of boxes with faces in common planes, thin walls and thin gaps.
Shape make_blocks(std::uint64_t round, test::Random& random);
Shape make_fins(std::uint64_t round, test::Random& random);
Shape make_slots(std::uint64_t round, test::Random& random);
Shape make_plate(std::uint64_t round, test::Random& random);

}  // namespace cdfr::soak
