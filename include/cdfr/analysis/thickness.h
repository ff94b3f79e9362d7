/// Wall thickness of a part, or the gaps around it: at samples of its surface, to a stated error, with
/// statistics and the thinnest places.
#pragma once

#include <cstdint>
#include <vector>

#include "cdfr/core/api.h"
#include "cdfr/core/result.h"
#include "cdfr/core/run.h"
#include "cdfr/core/types.h"
#include "cdfr/field/field.h"

namespace cdfr {

enum class ThicknessMethod : std::uint8_t {
  sphere,  ///< diameter of the largest ball inside that touches the wall at the sample
  ray,     ///< way to the first hit along the inward normal, or the shortest of a cone of rays
};

/// Where thickness is asked.
enum class SampleAt : std::uint8_t {
  faces,     ///< the centre of each triangle
  vertices,  ///< each vertex, those at one place taken as one
  spacing,   ///< several a triangle, no point farther than ThicknessOptions::spacing from one
};

/// What is said where a design edge holds the ball: there it shrinks to nothing, however thick the wall is.
enum class EdgePolicy : std::uint8_t {
  sphere,       ///< the ball's own diameter
  extrapolate,  ///< the value of the nearest sample of the same smooth region that no edge holds, if it has
                ///< one
  skip,         ///< such samples are left out of samples and statistics
};

struct ThicknessOptions {
  ThicknessMethod method = ThicknessMethod::sphere;
  SampleAt at = SampleAt::faces;
  double spacing = 0;  ///< with SampleAt::spacing
  /// D: the ball may enter the mesh by so much, for on a faceted mesh the ball at every edge of the
  /// tessellation has radius zero. 0 is exact on the mesh; negative takes the estimated chord error around
  /// each sample: none on plane faces (ThicknessReport::facet_estimate). For the sphere method.
  double facet = -1;
  double sharp = 30;  ///< degrees, above 0: an edge that turns more is a design edge, others are tessellation
  EdgePolicy edges = EdgePolicy::sphere;
  double error =
      0;  ///< largest ThicknessSample::error of the sphere method; 0 takes 2^-30 of the longest side
  double cone = 0;         ///< half the cone's opening in degrees, below 90, for the ray method
  int rays = 1;            ///< in the cone, the normal's own among them
  bool clearance = false;  ///< the gap outside instead of the wall inside
  /// A ball or ray of more than this finds nothing; 0 takes the diagonal of the box.
  double largest = 0;
  /// T: what is strictly thinner counts as thin; 0 takes the thinnest twentieth by area of what is opposed
  /// and away from design edges, and all that the tolerances cannot tell from it.
  double thinner_than = 0;
  int bins = 20;    ///< of the histogram
  int places = 20;  ///< thinnest places that are listed
};

/// Lengths in the mesh's unit. With the sphere method the largest ball's diameter lies in
/// [thickness, thickness + error] for this sample's facet tolerance D, or one larger by rounding (32 ulp of
/// the largest coordinate). With the ray method the first hit lies within `error` of the thickness.
struct ThicknessSample {
  Vec3 position;
  Vec3 normal;           ///< outward, unit; at a vertex the angle-weighted mean
  double thickness = 0;  ///< a diameter; NaN, and nothing in `opposite`, where nothing is met
  double error = 0;
  Vec3 opposite_point;                ///< where what holds the ball touches it, or the ray's hit
  std::uint32_t triangle = no_index;  ///< that it lies on: its number in the input; for a vertex the lowest
  std::uint32_t opposite = no_index;  ///< triangle of `opposite_point`
  std::uint32_t patch = 0, opposite_patch = 0;
  double area = 0;       ///< of the surface that it stands for
  double facet = 0;      ///< D as it was taken here
  bool at_edge = false;  ///< held by a wall across a convex design edge of its own region, or on such an edge
  /// What holds the ball touches it more than 120 degrees from the sample: a wall that tapers by less
  /// than 60. Else the ball is held from the sample's own side, by an edge, a fillet or a facet beside it,
  /// and there is no wall to be thin.
  bool opposed = false;
};

/// How the facet tolerance came about.
struct FacetEstimate {
  double median = 0, quantile = 0, largest = 0;  ///< chord error of curved triangles; quantile: 99 % by area
  std::uint64_t curved_triangles = 0;
};

/// Connected samples that are thin: walls, which are opposed and away from design edges, or others.
struct ThinPlace {
  Vec3 position;  ///< of its thinnest sample
  double thickness = 0, error = 0, facet = 0;
  double area = 0;
  std::uint32_t triangle = no_index;  ///< of its thinnest sample
  std::uint64_t samples = 0;
  bool at_edge = false, opposed = false;  ///< of its thinnest sample

  bool is_wall() const noexcept { return opposed && !at_edge; }
};

/// Weighted by area, over samples where something was met.
struct ThicknessReport {
  double facet = 0;               ///< largest of the samples'
  double error = 0, largest = 0;  ///< as they were taken; the ray method's error is the largest sample's
  FacetEstimate facet_estimate;   ///< empty unless it was asked for
  double rounding = 0;            ///< 32 ulp of the largest coordinate
  std::uint64_t queries = 0;      ///< closest points, or rays
  std::uint64_t regions = 0;      ///< smooth ones
  std::uint64_t samples = 0;      ///< that something was met by
  std::uint64_t unmet = 0, skipped = 0, at_edge = 0, extrapolated = 0;
  double area = 0;
  double min = 0, max = 0, mean = 0;  ///< NaN without samples
  double p1 = 0, p5 = 0, p25 = 0, p50 = 0, p75 = 0, p95 = 0, p99 = 0;
  std::vector<double> histogram;  ///< area by bin, of `bins` equal ones from min to max
  double thin_limit = 0;          ///< T, or the greatest of the thinnest twentieth
  double thin_area = 0;           ///< of thin samples
  double thin_wall_area = 0;      ///< of those that are opposed and away from design edges
  std::vector<ThinPlace> places;  ///< walls first, then by thickness
  std::uint64_t place_count = 0;  ///< of all, listed or not
};

struct Thickness {
  std::vector<ThicknessSample>
      samples;  ///< by triangle, or by lowest triangle and corner that has the vertex
  ThicknessReport report;
};

/// Sphere method: the largest r with depth(p - r n) >= r - D, by closest points alone. Each one that is
/// nearer than r - D bounds r from above, and the bound falls faster than linearly (Ma, Bae, Choi, "3D medial
/// axis point approximation using nearest neighbors and the normal field", 2012). Two parallel walls read D
/// too thick, a wall thinner than D (D + t)/2 of its t. On an open mesh only its surface holds the ball.
///
/// Ray method: what the inward normal meets first behind the sample, edges and grazed triangles included, but
/// for what touches the sample itself.
///
/// The same bytes for any number of threads. O(samples) memory, and a few closest points or one ray each.
/// Errors: bad_option (not finite or out of its range; error below 128 ulp of the largest coordinate; more
/// than 2^32 - 2 samples), not_closed (an unsigned field has no inside), cancelled; the field's own. Thread
/// safe.
CDFR_API Result<Thickness> thickness(const Field& field, const ThicknessOptions& options = {},
                                     const Run& run = {});

struct ThinningOptions {
  /// How far from a sample the former surface may be; 0 takes a hundredth of the longest side.
  double reach = 0;
  /// A wall thinned where it lost more than this; 0 takes both errors and both facet tolerances there.
  double change = 0;
};

struct ThinnedPlace {
  Vec3 position;  ///< of the sample that lost most
  double thickness = 0, former = 0;
  double error = 0;  ///< of their difference
  double area = 0;
  std::uint32_t triangle = no_index;
  std::uint64_t samples = 0;
};

struct Thinning {
  double reach = 0, change = 0;  ///< as they were taken
  std::uint64_t compared = 0;    ///< samples
  std::uint64_t at_edge = 0;  ///< left out: a ball that an edge holds shrinks with the way to the edge alone
  std::uint64_t unmatched = 0;  ///< no former surface near that faces as they do, or nothing met on one side
  double area = 0;              ///< that thinned
  std::vector<ThinnedPlace> places;  ///< connected samples that thinned, by what they lost
};

/// Where walls of `field` are thinner than those of a former revision: the former one is measured with the
/// same options where its surface is closest to each sample. `now` is thickness(field, options). Errors: as
/// thickness. Thread safe.
CDFR_API Result<Thinning> thinning(const Field& field, const Thickness& now, const ThicknessOptions& options,
                                   const Field& former, const ThinningOptions& how = {}, const Run& run = {});

}  // namespace cdfr
