/// double_double.h in the lanes of vectors: the same operations in the same order, so the same bits in each
/// lane. Included by sources that Highway compiles once for each instruction set, after their
/// foreach_target.h.
#if defined(CDFR_DOUBLE_DOUBLE_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef CDFR_DOUBLE_DOUBLE_LANES
#undef CDFR_DOUBLE_DOUBLE_LANES
#else
#define CDFR_DOUBLE_DOUBLE_LANES
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace cdfr {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, 8>;

/// Two registers: double-double is one long chain of dependent operations, and two chains side by side take
/// hardly longer than one.
struct Vector {
  hn::Vec<Tag> first, second;
};

struct Mask {
  hn::Mask<Tag> first, second;
};

HWY_INLINE std::size_t vector_lanes() { return 2 * hn::Lanes(Tag()); }

HWY_INLINE Vector constant(double value) { return {hn::Set(Tag(), value), hn::Set(Tag(), value)}; }
HWY_INLINE Vector load(const double* from) {
  return {hn::Load(Tag(), from), hn::Load(Tag(), from + hn::Lanes(Tag()))};
}
HWY_INLINE void store(Vector a, double* to) {
  hn::Store(a.first, Tag(), to);
  hn::Store(a.second, Tag(), to + hn::Lanes(Tag()));
}

HWY_INLINE Vector operator+(Vector a, Vector b) {
  return {hn::Add(a.first, b.first), hn::Add(a.second, b.second)};
}
HWY_INLINE Vector operator-(Vector a, Vector b) {
  return {hn::Sub(a.first, b.first), hn::Sub(a.second, b.second)};
}
HWY_INLINE Vector operator*(Vector a, Vector b) {
  return {hn::Mul(a.first, b.first), hn::Mul(a.second, b.second)};
}
HWY_INLINE Vector operator/(Vector a, Vector b) {
  return {hn::Div(a.first, b.first), hn::Div(a.second, b.second)};
}
HWY_INLINE Vector operator-(Vector a) { return {hn::Neg(a.first), hn::Neg(a.second)}; }
HWY_INLINE Vector absolute(Vector a) { return {hn::Abs(a.first), hn::Abs(a.second)}; }
HWY_INLINE Vector root(Vector a) { return {hn::Sqrt(a.first), hn::Sqrt(a.second)}; }
HWY_INLINE Vector least_of(Vector a, Vector b) {
  return {hn::Min(a.first, b.first), hn::Min(a.second, b.second)};
}
HWY_INLINE Vector most_of(Vector a, Vector b) {
  return {hn::Max(a.first, b.first), hn::Max(a.second, b.second)};
}

HWY_INLINE Mask operator<(Vector a, Vector b) {
  return {hn::Lt(a.first, b.first), hn::Lt(a.second, b.second)};
}
HWY_INLINE Mask operator>(Vector a, Vector b) { return b < a; }
HWY_INLINE Mask operator<=(Vector a, Vector b) {
  return {hn::Le(a.first, b.first), hn::Le(a.second, b.second)};
}
HWY_INLINE Mask operator==(Vector a, Vector b) {
  return {hn::Eq(a.first, b.first), hn::Eq(a.second, b.second)};
}
HWY_INLINE Mask operator&(Mask a, Mask b) { return {hn::And(a.first, b.first), hn::And(a.second, b.second)}; }
HWY_INLINE Mask operator|(Mask a, Mask b) { return {hn::Or(a.first, b.first), hn::Or(a.second, b.second)}; }
HWY_INLINE bool any(Mask a) { return !hn::AllFalse(Tag(), hn::Or(a.first, a.second)); }
HWY_INLINE bool all(Mask a) { return hn::AllTrue(Tag(), hn::And(a.first, a.second)); }
HWY_INLINE Vector choose(Mask mask, Vector yes, Vector no) {
  return {hn::IfThenElse(mask.first, yes.first, no.first),
          hn::IfThenElse(mask.second, yes.second, no.second)};
}

struct Vector3 {
  Vector x, y, z;
};

HWY_INLINE Vector3 choose(Mask mask, const Vector3& yes, const Vector3& no) {
  return {choose(mask, yes.x, no.x), choose(mask, yes.y, no.y), choose(mask, yes.z, no.z)};
}

struct Doubled {
  Vector hi, lo;
};

struct Doubled3 {
  Doubled x, y, z;
};

HWY_INLINE Doubled choose(Mask mask, const Doubled& yes, const Doubled& no) {
  return {choose(mask, yes.hi, no.hi), choose(mask, yes.lo, no.lo)};
}

HWY_INLINE Doubled3 choose(Mask mask, const Doubled3& yes, const Doubled3& no) {
  return {choose(mask, yes.x, no.x), choose(mask, yes.y, no.y), choose(mask, yes.z, no.z)};
}

HWY_INLINE Doubled two_sum(Vector a, Vector b) {
  const Vector s = a + b;
  const Vector t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

HWY_INLINE Doubled quick_two_sum(Vector a, Vector b) {
  const Vector s = a + b;
  return {s, b - (s - a)};
}

HWY_INLINE Doubled split(Vector a) {
  const Vector c = constant(0x1.0000002p27) * a;
  const Vector hi = c - (c - a);
  return {hi, a - hi};
}

HWY_INLINE Doubled two_product(Vector a, Vector b) {
  const Vector p = a * b;
  const Doubled x = split(a);
  const Doubled y = split(b);
  return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
}

HWY_INLINE Doubled operator-(const Doubled& a) { return {-a.hi, -a.lo}; }

HWY_INLINE Doubled operator+(const Doubled& a, const Doubled& b) {
  const Doubled s = two_sum(a.hi, b.hi);
  const Doubled t = two_sum(a.lo, b.lo);
  const Doubled v = quick_two_sum(s.hi, s.lo + t.hi);
  return quick_two_sum(v.hi, t.lo + v.lo);
}

HWY_INLINE Doubled operator-(const Doubled& a, const Doubled& b) { return a + -b; }

HWY_INLINE Doubled operator*(const Doubled& a, const Doubled& b) {
  const Doubled p = two_product(a.hi, b.hi);
  return quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

HWY_INLINE Doubled operator*(const Doubled& a, Vector b) {
  const Doubled p = two_product(a.hi, b);
  return quick_two_sum(p.hi, p.lo + a.lo * b);
}

HWY_INLINE Doubled operator/(const Doubled& a, const Doubled& b) {
  const Vector q = a.hi / b.hi;
  const Doubled rest = a - b * q;
  return quick_two_sum(q, (rest.hi + rest.lo) / b.hi);
}

HWY_INLINE Vector square_root(const Doubled& a) {
  const Vector s = root(a.hi);
  const Doubled square = two_product(s, s);
  const Vector zero = constant(0);
  const Vector corrected = s + ((a.hi - square.hi) - square.lo + a.lo) / (constant(2) * s);
  return choose(a.hi > zero, corrected, zero);
}

HWY_INLINE Doubled3 difference(const Vector3& p, const Vector3& q) {
  return {two_sum(p.x, -q.x), two_sum(p.y, -q.y), two_sum(p.z, -q.z)};
}

HWY_INLINE Doubled dot(const Doubled3& a, const Doubled3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace HWY_NAMESPACE
}  // namespace cdfr
HWY_AFTER_NAMESPACE();

#endif
