/// Strokes for letters and triangles for balls.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "export/icosphere.h"
#include "export/lettering.h"
#include "export/stroke_font.h"

namespace cdfr {
namespace {

std::set<std::tuple<double, double, double, double>> shape_of(const std::string& text) {
  std::set<std::tuple<double, double, double, double>> shape;
  for (const Stroke& s : strokes_of(text)) shape.insert({s.x0, s.y0, s.x1, s.y1});
  return shape;
}

TEST(StrokeFont, EveryPrintableLetterHasAShapeOfItsOwn) {
  std::set<std::set<std::tuple<double, double, double, double>>> shapes;
  for (char letter = '!'; letter <= '~'; ++letter) {
    const auto shape = shape_of(std::string(1, letter));
    EXPECT_FALSE(shape.empty()) << letter;
    EXPECT_TRUE(shapes.insert(shape).second) << letter;
  }
  EXPECT_TRUE(shape_of(" ").empty());
  EXPECT_EQ(shapes.count(shape_of("\xc2\xb1")), 0U) << "the box is no letter";
}

TEST(StrokeFont, LettersStayInTheirCells) {
  for (char letter = '!'; letter <= '~'; ++letter) {
    for (const Stroke& s : strokes_of(std::string(1, letter))) {
      EXPECT_TRUE(s.x0 != s.x1 || s.y0 != s.y1) << letter;
      for (const double x : {s.x0, s.x1}) EXPECT_TRUE(x >= 0 && x <= text_width("W")) << letter;
      for (const double y : {s.y0, s.y1}) EXPECT_TRUE(y >= -1.0 / 3 - 1e-12 && y <= 1) << letter;
    }
  }
}

TEST(StrokeFont, ACharacterOfSeveralBytesIsOneBox) {
  EXPECT_EQ(shape_of("\xc2\xb1"), shape_of("\xe2\x82\xac"));
  EXPECT_EQ(shape_of("\xc2\xb1"), shape_of("\xff"));
  EXPECT_EQ(text_width("\xe2\x82\xac"), text_width("a"));
  EXPECT_EQ(text_width(""), 0);
  EXPECT_GT(text_width("ab"), 2 * text_width("a"));
}

TEST(Lettering, FacesTheViewerInItsPlane) {
  Lettering letters(3, 0.5);
  letters.write("17.0 mm +- 0.1", 1, 2);
  const auto& corners = letters.corners();
  ASSERT_FALSE(corners.empty());
  ASSERT_EQ(corners.size() % 3, 0U);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const auto &a = corners[i], &b = corners[i + 1], &c = corners[i + 2];
    EXPECT_GT((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0);
    EXPECT_EQ(a[2], 0.5F);
  }
}

TEST(Icosphere, IsClosedOutwardAndRound) {
  const Icosphere sphere = icosphere();
  EXPECT_EQ(sphere.vertices.size(), 642U);
  ASSERT_EQ(sphere.corners.size(), 3 * 1280U);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0;
  for (std::size_t i = 0; i < sphere.corners.size(); i += 3) {
    const auto &a = sphere.vertices.at(sphere.corners[i]), &b = sphere.vertices.at(sphere.corners[i + 1]),
               &c = sphere.vertices.at(sphere.corners[i + 2]);
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0])) /
              6;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{sphere.corners[i + k], sphere.corners[i + (k + 1) % 3]}];
    for (const auto* v : {&a, &b, &c})
      EXPECT_NEAR((*v)[0] * (*v)[0] + (*v)[1] * (*v)[1] + (*v)[2] * (*v)[2], 1, 1e-6);
    const auto middle = [&](std::size_t k) { return double(a[k] + b[k] + c[k]) / 3; };
    EXPECT_GT(std::sqrt(middle(0) * middle(0) + middle(1) * middle(1) + middle(2) * middle(2)), 0.99);
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  EXPECT_NEAR(volume, 4.18879, 0.05);
}

}  // namespace
}  // namespace cdfr
