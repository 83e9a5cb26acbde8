#include "app/dataset/field_transport.h"
#include "core/base/error.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>

namespace pbffd {

class FieldTransportTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void kindIsReadFromTheEnd() {
    QCOMPARE(parseTransport("velocity").array, std::string("velocity"));
    QVERIFY(!parseTransport("velocity").kind.has_value());
    QVERIFY(parseTransport("a:vector").kind == FieldKind::vector);
    QVERIFY(parseTransport("a:b:normal").kind == FieldKind::normal);
    QCOMPARE(parseTransport("a:b:normal").array, std::string("a:b"));
    QCOMPARE(parseTransport("a:scalar").array, std::string("a:scalar"));
    QVERIFY_EXCEPTION_THROWN(parseTransport(""), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(parseTransport(":vector"), InvalidInput);
  }

  void arrayNamedTwiceIsAnError() {
    QCOMPARE(parseTransports({"velocity", "n:normal"}).size(), std::size_t{2});
    QVERIFY_EXCEPTION_THROWN(parseTransports({"velocity", "velocity:vector"}), InvalidInput);
  }

  void normalsAreKnownByTheirNames() {
    QVERIFY(namesNormals("Normals") && namesNormals("normal") && namesNormals("PointNormals"));
    QVERIFY(!namesNormals("abnormal stress") && !namesNormals("velocity"));
  }

  void vectorsFollowTheMaterial() {
    Mat3 gradient;
    gradient << 1, 2, 0, 0, 1, 0, 0, 0, 3;
    QVERIFY(transported(gradient, Vec3(1, 1, 1), FieldKind::vector) == Vec3(3, 1, 3));
  }

  void normalsStaySquareToTheSurfaceAndKeepTheirLength() {
    Mat3 gradient;
    gradient << 1.1, 0.7, 0.2, -0.3, 0.9, 0.1, 0.4, 0.2, 1.7;
    const Vec3 first(1, 0.5, 0);
    const Vec3 second(0, 1, 2);
    const Vec3 normal = 3.0 * first.cross(second).normalized();
    for (const Mat3& map : {gradient, Mat3(-gradient)}) {
      const Vec3 turned = transported(map, normal, FieldKind::normal);
      QVERIFY(std::abs(turned.dot(map * first)) < 1e-14 && std::abs(turned.dot(map * second)) < 1e-14);
      QVERIFY(std::abs(turned.norm() - 3.0) < 1e-14);
      // On the side that the turned triangle itself has.
      QVERIFY(turned.dot((map * first).cross(map * second)) > 0.0);
    }
  }

  void normalOfACollapsedPlaceStays() {
    QVERIFY(transported(Mat3::Zero(), Vec3(0, 0, 2), FieldKind::normal) == Vec3(0, 0, 2));
  }
};

const test::Registration<FieldTransportTest> registration;

}  // namespace pbffd

#include "field_transport_test.moc"
