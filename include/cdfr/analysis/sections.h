/// Heavy sections: the connected regions of a part that are deeper than a given depth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cdfr/analysis/ball.h"
#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/core/types.h"
#include "cdfr/field/field.h"

namespace cdfr {

struct SectionsOptions {
  /// e, in the mesh's unit: how far from its true place the border of a section may be taken to be; 0 takes
  /// the longest side / 1000.
  double error = 0;
  double min_volume = 0;  ///< sections of less volume are left out
  double min_depth = 0;   ///< sections whose ball has a lesser radius are left out
};

/// One connected region of {depth > T}.
struct Section {
  InscribedBall ball;       ///< the largest with its centre in the section
  double volume = 0;        ///< of the section
  double volume_error = 0;  ///< the true volume is within this of `volume`
  double area = 0;          ///< of the section's own surface {depth = T}
  double area_error = 0;    ///< an estimate: the sum over cells of what their tilt and roughness may change
  Box box;                  ///< holds the section; the depth where it sticks out is above T - 2 e
  std::uint64_t cells = 0;  ///< cubes that it is made of
  /// The part's triangles around it, numbers in the input, ascending. All that are closest to a point of the
  /// section's surface are among them, and each is within 4 e of being closest to one.
  std::vector<std::uint32_t> triangles;
};

/// Two sections that are one if the depth at some point near `place` exceeds T, which could not be decided.
struct MayJoin {
  std::size_t first = 0, second = 0;  ///< places in Sections::sections, first < second
  Vec3 place;
  double depth = 0;  ///< at that place
};

struct Sections {
  double depth = 0;  ///< T
  double error = 0;  ///< e
  /// By the radius of the ball, the largest first.
  std::vector<Section> sections;
  std::vector<MayJoin> may_join;  ///< by first, second
  std::vector<Vec3> undecided;    ///< places around which a tiny section may be: none deeper than T + 2 e
  std::uint64_t left_out = 0;     ///< sections below min_volume or min_depth
  std::uint64_t cells = 0;        ///< cubes kept at once at most
  std::uint64_t evaluations = 0;  ///< cubes whose depth was looked at
};

/// The connected components of {x : depth of x > depth}, by a descent over the field's leaves: cubes are
/// halved until they are certainly inside, certainly outside, cut by what is flat to e / 2, or have a half
/// diagonal of at most e. The comparison is strict; a section deeper than `depth` by no more than 512
/// ulp of the largest coordinate is none. A component of cubes without a point deeper than `depth` is
/// dropped, by proof. Where two sections only meet in cubes in doubt, these are halved further; what then
/// remains open is told in may_join. What is deeper than T by less than 2 e and only linked to a section by
/// cubes in doubt counts as part of that section.
///
/// On an open mesh sections end where the sign changes off the surface. Time and memory go with the sections'
/// surface over e^2, not with the field. Same bits for any number of threads. Errors: bad_option (depth not
/// finite or not above 0; error not finite, below 2^-14 of the longest side or 2^14 ulp of the largest
/// coordinate; the others negative or not finite), not_closed (an unsigned field has no inside), cancelled;
/// status().
CDFR_API Result<Sections> heavy_sections(const Field& field, double depth,
                                         const SectionsOptions& options = {}, const Run& run = {});

}  // namespace cdfr
