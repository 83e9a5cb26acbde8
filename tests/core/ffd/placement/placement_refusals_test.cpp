#include "core/base/error.h"
#include "core/ffd/placement/placement.h"
#include "tests/core/ffd/placement/placed.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd {
namespace {

using test::place;
using test::stretched;
using test::withPoints;

}  // namespace

class PlacementRefusalsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void facesWithoutAreaAreRefused() {
    Mesh mesh;
    mesh.positions = test::cube().positions;
    mesh.faces.add(std::vector<Index>{0, 1, 1});
    mesh.faces.add(std::vector<Index>{2, 7, 2});
    try {
      place(mesh, withPoints(10));
      QFAIL("placed");
    } catch (const InvalidInput& error) {
      QVERIFY(std::string(error.what()).find("area") != std::string::npos);
    }
  }

  void tooLittleToPlaceOnIsRefused() {
    Mesh cloud;
    cloud.positions = Points::Random(20, 3);
    QVERIFY_EXCEPTION_THROWN(place(cloud, withPoints(10)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(place(Mesh(), withPoints(10)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(place(stretched(test::cube(), Vec3(1, 0, 0)), withPoints(10)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(place(stretched(test::cube(), Vec3(0, 0, 0)), withPoints(10)), InvalidInput);
    Mesh broken = test::cube();
    broken.positions(3, 1) = std::numeric_limits<double>::quiet_NaN();
    try {
      place(broken, withPoints(10));
      QFAIL("no error");
    } catch (const InvalidInput& error) {
      QVERIFY(std::string(error.what()).find("vertex 3") != std::string::npos);
    }
  }

  void sizesBeyondDoublePrecisionAreRefused() {
    for (const double scale : {1e150, 1e-150}) {
      try {
        place(test::placedAt(test::cube(), scale, Vec3::Zero()), withPoints(10));
        QFAIL("placed");
      } catch (const InvalidInput& error) {
        QVERIFY(std::string_view(error.what()).find("diagonal") != std::string_view::npos);
      }
    }
  }

  void optionsOutOfRangeAreRefusedByName() {
    const auto refused = [](const auto& change, const std::string& name) {
      PlacementOptions options;
      change(options);
      try {
        requireValid(options);
      } catch (const InvalidInput& error) {
        return std::string(error.what()).find(name) != std::string::npos;
      }
      return false;
    };
    requireValid({});
    requireValid(paperOptions());
    QVERIFY(refused([](auto& o) { o.points = 0; }, "points"));
    QVERIFY(refused([](auto& o) { o.points = 20001; }, "points"));
    QVERIFY(refused([](auto& o) { o.levels = 0; }, "levels"));
    QVERIFY(refused([](auto& o) { o.basis.sigma = 0.0; }, "sigma"));
    QVERIFY(refused([](auto& o) { o.master = -1.0; }, "master"));
    QVERIFY(refused([](auto& o) { o.radiusFactor = 0.0; }, "radius factor"));
    QVERIFY(refused([](auto& o) { o.offset = std::numeric_limits<double>::quiet_NaN(); }, "offset"));
    QVERIFY(refused([](auto& o) { o.exteriorShare = 1.1; }, "exterior share"));
    QVERIFY(refused([](auto& o) { o.sites = -1; }, "sites"));
  }
};

const test::Registration<PlacementRefusalsTest> registration;

}  // namespace pbffd

#include "placement_refusals_test.moc"
