/// Painted meshes for ParaView: every bit comes back.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "cdfr/export/painted.h"
#include "export/painted_case.h"
#include "export/vtp_parse.h"
#include "support/scratch.h"

namespace cdfr {
namespace {

class PaintedVtpTest : public ScratchTest {
 protected:
  VtpParse written(const PaintedMesh& painted) {
    const auto result = write_painted(painted, folder() / "a.vtp");
    EXPECT_TRUE(result) << result.error().text;
    return VtpParse(text_of(folder() / "a.vtp"));
  }
};

std::vector<std::uint64_t> bits_of(const std::vector<double>& values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

std::vector<double> with_blanks(std::vector<double> values, std::size_t before, std::size_t after) {
  values.insert(values.begin(), before, PaintedCase::nan);
  values.insert(values.end(), after, PaintedCase::nan);
  return values;
}

TEST_F(PaintedVtpTest, ArraysComeBackBitByBit) {
  const PaintedCase made;
  const VtpParse vtp = written(made.painted());
  EXPECT_EQ(vtp.piece.at("NumberOfPoints"), "8");
  EXPECT_EQ(vtp.piece.at("NumberOfVerts"), "4");
  EXPECT_EQ(vtp.piece.at("NumberOfPolys"), "4");
  EXPECT_EQ(vtp.scalars, (std::map<std::string, std::string>{{"PointData", "thickness"}}));
  EXPECT_EQ(bits_of(vtp.arrays.at("PointData/thickness").numbers<double>()),
            bits_of(with_blanks(made.thickness, 0, 4)));
  EXPECT_EQ(bits_of(vtp.arrays.at("PointData/error").numbers<double>()),
            bits_of(with_blanks(made.error, 0, 4)));
  EXPECT_EQ(bits_of(vtp.arrays.at("CellData/depth_of_face").numbers<double>()),
            bits_of(with_blanks(made.depth, 4, 0)));
  EXPECT_EQ(vtp.arrays.at("CellData/patch").numbers<std::uint32_t>(),
            (std::vector<std::uint32_t>{no_index, no_index, no_index, no_index, 7, 7, 0, 7}));
  const auto colours = vtp.arrays.at("PointData/colour").numbers<std::uint8_t>();
  ASSERT_EQ(colours.size(), 24U);
  for (std::size_t i = 0; i < 8; ++i) {
    const Colour colour = painted_colour(i < 4 ? made.thickness[i] : PaintedCase::nan, 1, 11);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(colours[3 * i + k], colour[k]);
  }
}

TEST_F(PaintedVtpTest, PointsAndCellsAreMeshThenBallsThenLabels) {
  const PaintedCase made;
  const PaintedMesh painted = made.painted();
  const VtpParse vtp = written(painted);
  std::vector<double> expected;
  const auto add = [&](Vec3 p) { expected.insert(expected.end(), {p.x, p.y, p.z}); };
  for (const Vec3& vertex : made.mesh.vertices) add(vertex);
  for (const PaintedBall& ball : painted.balls) add(ball.centre);
  for (const PaintedLabel& label : painted.labels) add(label.place);
  const auto& points = vtp.arrays.at("Points/points");
  EXPECT_EQ(points.attributes.at("NumberOfComponents"), "3");
  EXPECT_EQ(bits_of(points.numbers<double>()), bits_of(expected));
  using Numbers = std::vector<std::int64_t>;
  EXPECT_EQ(vtp.arrays.at("Verts/connectivity").numbers<std::int64_t>(), (Numbers{4, 5, 6, 7}));
  EXPECT_EQ(vtp.arrays.at("Verts/offsets").numbers<std::int64_t>(), (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(vtp.arrays.at("Polys/connectivity").numbers<std::int64_t>(),
            (Numbers{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(vtp.arrays.at("Polys/offsets").numbers<std::int64_t>(), (Numbers{3, 6, 9, 12}));
  const auto radius = vtp.arrays.at("PointData/radius").numbers<double>();
  EXPECT_EQ(bits_of(radius), bits_of(with_blanks({0.125, 1e-3}, 4, 2)));
  EXPECT_EQ(
      vtp.arrays.at("PointData/label").strings(),
      (std::vector<std::string>{"", "", "", "", "", "", "1: 17.0 mm +- 0.1", "two lines \xc2\xb1 & <b>"}));
}

TEST_F(PaintedVtpTest, FieldDataSayWhatTheColoursMeanAndWhereAllComesFrom) {
  const VtpParse vtp = written(PaintedCase().painted());
  EXPECT_EQ(vtp.arrays.at("FieldData/painted").coded_strings(),
            std::vector<std::string>{"thickness from 1 (yellow) to 11 (dark blue) mm"});
  EXPECT_EQ(vtp.arrays.at("FieldData/painted_range").bytes, " 1 11 ");
  EXPECT_EQ(vtp.arrays.at("FieldData/unit").coded_strings(), std::vector<std::string>{"mm"});
  EXPECT_EQ(vtp.arrays.at("FieldData/notes").coded_strings(),
            (std::vector<std::string>{"sha256: 00ff", "two lines"}));
  EXPECT_EQ(vtp.arrays.at("FieldData/notes").attributes.at("NumberOfTuples"), "2");
}

TEST_F(PaintedVtpTest, PaintOnTrianglesIsCellData) {
  PaintedCase made;
  made.painted_array = "depth_of_face";
  const VtpParse vtp = written(made.painted());
  EXPECT_EQ(vtp.scalars, (std::map<std::string, std::string>{{"CellData", "depth_of_face"}}));
  const auto colours = vtp.arrays.at("CellData/colour").numbers<std::uint8_t>();
  ASSERT_EQ(colours.size(), 24U);
  const Colour last = painted_colour(1e300, 1, 11);
  EXPECT_EQ((Colour{colours[21], colours[22], colours[23]}), last);
  EXPECT_EQ(vtp.arrays.count("PointData/colour"), 0U);
}

TEST_F(PaintedVtpTest, AMeshAloneAndNothingAtAllAreFilesToo) {
  const PaintedCase made;
  const VtpParse plain = written(PaintedMesh{made.mesh.view()});
  EXPECT_EQ(plain.piece.at("NumberOfPoints"), "4");
  EXPECT_EQ(plain.piece.at("NumberOfVerts"), "0");
  EXPECT_EQ(plain.arrays.count("PointData/radius") + plain.arrays.count("PointData/label"), 0U);
  const VtpParse nothing = written({});
  EXPECT_EQ(nothing.piece.at("NumberOfPoints"), "0");
  EXPECT_EQ(nothing.arrays.at("Points/points").bytes, "");
}

}  // namespace
}  // namespace cdfr
