/// Answers of a query as a table: CSV, NPY or PLY.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "byte_sink.h"
#include "cdfr/core/types.h"
#include "cdfr/field/field.h"

namespace cdfr::command {

/// Takes blocks of answers in order. Rows are as many as were announced.
class AnswerTable {
 public:
  virtual ~AnswerTable() = default;
  virtual void begin(ByteSink& sink, std::uint64_t rows) = 0;
  virtual void append(ByteSink& sink, std::span<const Vec3> points, std::span<const Closest> answers) = 0;
};

/// ".csv": distance,cx,cy,cz,gx,gy,gz,triangle,feature with a header line, digits that read back the same
/// bits.
/// ".npy": (n,9) little endian doubles, the same columns, feature 0 face, 1 edge, 2 vertex.
/// ".ply": binary little endian vertices x y z distance cx cy cz gx gy gz (double) triangle (uint) feature
/// (uchar).
std::unique_ptr<AnswerTable> answer_table(const std::string& extension);

}  // namespace cdfr::command
