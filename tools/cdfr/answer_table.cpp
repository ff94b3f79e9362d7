#include "answer_table.h"

#include <array>
#include <cstddef>

#include "binary.h"
#include "number_text.h"

namespace cdfr::command {
namespace {

constexpr std::array<const char*, 3> feature_names{"face", "edge", "vertex"};
constexpr std::array<const char*, 7> measures{"distance", "cx", "cy", "cz", "gx", "gy", "gz"};

std::size_t number_of(Feature feature) noexcept { return static_cast<std::size_t>(feature); }

std::array<double, 7> measures_of(const Closest& answer) noexcept {
  const Vec3 &point = answer.point, &gradient = answer.gradient;
  return {answer.distance, point.x, point.y, point.z, gradient.x, gradient.y, gradient.z};
}

class CsvTable final : public AnswerTable {
 public:
  void begin(ByteSink& sink, std::uint64_t) override {
    sink.write("distance,cx,cy,cz,gx,gy,gz,triangle,feature\n");
  }
  void append(ByteSink& sink, std::span<const Vec3>, std::span<const Closest> answers) override {
    std::string text;
    for (const Closest& answer : answers) {
      for (const double measure : measures_of(answer)) {
        append_exact(text, measure);
        text += ',';
      }
      text += std::to_string(answer.triangle) + "," + feature_names[number_of(answer.feature)] + "\n";
    }
    sink.write(text);
  }
};

class NpyTable final : public AnswerTable {
 public:
  void begin(ByteSink& sink, std::uint64_t rows) override {
    sink.write(npy_header("(" + std::to_string(rows) + ", 9)"));
  }
  void append(ByteSink& sink, std::span<const Vec3>, std::span<const Closest> answers) override {
    std::string bytes;
    for (const Closest& answer : answers) {
      for (const double measure : measures_of(answer)) append_bytes(bytes, measure);
      append_bytes(bytes, static_cast<double>(answer.triangle));
      append_bytes(bytes, static_cast<double>(number_of(answer.feature)));
    }
    sink.write(bytes);
  }
};

class PlyTable final : public AnswerTable {
 public:
  void begin(ByteSink& sink, std::uint64_t rows) override {
    std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(rows) + "\n";
    for (const char* name : {"x", "y", "z"}) header += std::string("property double ") + name + "\n";
    for (const char* name : measures) header += std::string("property double ") + name + "\n";
    sink.write(header + "property uint triangle\nproperty uchar feature\nend_header\n");
  }
  void append(ByteSink& sink, std::span<const Vec3> points, std::span<const Closest> answers) override {
    std::string bytes;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      for (const double coordinate : {points[i].x, points[i].y, points[i].z}) append_bytes(bytes, coordinate);
      for (const double measure : measures_of(answers[i])) append_bytes(bytes, measure);
      append_bytes(bytes, answers[i].triangle);
      bytes += static_cast<char>(number_of(answers[i].feature));
    }
    sink.write(bytes);
  }
};

}  // namespace

std::unique_ptr<AnswerTable> answer_table(const std::string& extension) {
  if (extension == ".npy") return std::make_unique<NpyTable>();
  if (extension == ".ply") return std::make_unique<PlyTable>();
  return std::make_unique<CsvTable>();
}

}  // namespace cdfr::command
