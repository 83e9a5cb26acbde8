#include "core/base/error.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <cmath>

namespace pbffd {

using namespace test;

namespace {

const std::string quad =
    "# made by hand\r\nmtllib a.mtl\r\n\r\no quad\r\n"
    "v  0.000 0 -0.0 # origin\r\nv 1.0e0\t0 0 0.5 0.5 0.5\r\n  v 1 1 0 1.0\r\nv 0 \\\r\n 1.50 0\r\n"
    "vt 0.5 0.50\r\nvn 1.000 0 0\r\nvn 0 0 2.0\r\nvn 0 3 4\r\n"
    "usemtl red\r\ns off\r\nf 1/1/1 2/1/1 3/1/2 4/1/2   \r\nl 1 3";

}  // namespace

class ObjRewriteTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void unmovedMeshIsTheSource() {
    const Mesh mesh = parsed("a.obj", quad);
    QCOMPARE(rewritten(mesh, atRest(mesh)), quad);
    QCOMPARE(rewritten(mesh, moved(mesh, Mat3::Identity())), quad);
  }

  void onlyTheNumbersThatMovedChange() {
    const Mesh mesh = parsed("a.obj", quad);
    DeformedShape shape = moved(mesh, Mat3::Identity());
    shape.positions(0, 1) = 0.1;
    shape.positions(3, 1) = -1.0 / 3.0;
    std::string expected = replaced(quad, "v  0.000 0 -0.0", "v  0.000 0.1 -0.0");
    expected = replaced(expected, " 1.50 0\r\n", " -0.3333333333333333 0\r\n");
    QCOMPARE(rewritten(mesh, shape), expected);
  }

  void movedPositionsReadBackToTheLastBit() {
    const Mesh mesh = parsed("a.obj", quad);
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const DeformedShape shape = moved(mesh, 1e-3 * turn, Vec3(1e10, 0.1, -7));
    const Mesh again = parsed("a.obj", rewritten(mesh, shape));
    QVERIFY(again.positions == shape.positions);
    QCOMPARE(again.faces.vertices(), mesh.faces.vertices());
    QCOMPARE(again.attributes.size(), mesh.attributes.size());
  }

  void normalsTurnAndKeepTheirLength() {
    const Mesh mesh = parsed("a.obj", quad);
    std::string expected = replaced(quad, "vn 1.000 0 0", "vn 0 1 0");
    expected = replaced(expected, "1.0e0\t0 0 0.5", "0\t1 0 0.5");
    expected = replaced(expected, "v 1 1 0 1.0", "v -1 1 0 1.0");
    expected = replaced(expected, "v 0 \\\r\n 1.50", "v -1.5 \\\r\n 0");
    QCOMPARE(rewritten(mesh, moved(mesh, quarterTurn())), expected);
  }

  void normalIsTheMeanOverTheCornersThatUseIt() {
    const Mesh mesh = parsed("a.obj", quad);
    DeformedShape shape = moved(mesh, Mat3::Identity(), Vec3(1, 0, 0));
    shape.gradients[1] = quarterTurn();
    const Mesh again = parsed("a.obj", rewritten(mesh, shape));
    const std::vector<double>& values = attribute(again, "vn", AttributeDomain::corner)->values;
    QVERIFY(std::abs(values[0] - std::sqrt(0.5)) < 1e-15);
    QVERIFY(std::abs(values[1] - std::sqrt(0.5)) < 1e-15);
    QCOMPARE(values[2], 0.0);
    QCOMPARE(std::vector<double>(values.begin() + 3, values.end()), (std::vector<double>{0, 0, 2, 0, 3, 4}));
  }

  void normalsFollowAStretchByTheInverseTranspose() {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0.8 0\nf 1//1 2//1 3//1\n";
    const Mesh mesh = parsed("a.obj", text);
    const Mat3 stretch = Vec3(2, 1, 1).asDiagonal();
    const Mesh again = parsed("a.obj", rewritten(mesh, moved(mesh, stretch)));
    const std::vector<double>& values = attribute(again, "vn", AttributeDomain::corner)->values;
    const Vec3 expected = Vec3(0.3, 0.8, 0).normalized();
    QVERIFY((Vec3(values.data()) - expected).norm() < 1e-15);
  }

  void withoutGradientsNormalsTurnWithTheFaces() {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
    const Mesh mesh = parsed("a.obj", text);
    DeformedShape shape = moved(mesh, Eigen::AngleAxisd(1.0, Vec3::UnitX()).toRotationMatrix());
    shape.gradients.clear();
    const Mesh again = parsed("a.obj", rewritten(mesh, shape));
    const std::vector<double>& values = attribute(again, "vn", AttributeDomain::corner)->values;
    QVERIFY((Vec3(values.data()) - Vec3(0, -std::sin(1.0), std::cos(1.0))).norm() < 1e-15);
    shape.positions = mesh.positions.array() + 1.0;
    QVERIFY(rewritten(mesh, shape).find("vn 0 0 1\n") != std::string::npos);
  }

  void normalsThatCancelOutOrAreNoNumbersStay() {
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn nan 0 0\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//2 2//2 3//3\n";
    const Mesh mesh = parsed("a.obj", text);
    DeformedShape shape = moved(mesh, -Mat3::Identity());
    shape.gradients = {quarterTurn(), quarterTurn().transpose(), Mat3::Zero()};
    const std::string result = rewritten(mesh, shape);
    QVERIFY(result.find("vn 1 0 0\nvn nan 0 0\nvn 0 0 0\n") != std::string::npos);
  }

  void shapesThatDoNotFitAreRefused() {
    const Mesh mesh = parsed("a.obj", quad);
    QVERIFY_EXCEPTION_THROWN(rewritten(mesh, {Points::Zero(3, 3), {}}), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(rewritten(mesh, {mesh.positions, std::vector<Mat3>(1)}), InvalidInput);
    DeformedShape shape = atRest(mesh);
    shape.positions(1, 1) = std::nan("");
    QVERIFY_EXCEPTION_THROWN(rewritten(mesh, shape), InvalidInput);
  }

  void cancelStopsWriting() {
    std::string text;
    for (int i = 0; i < 20000; ++i) {
      text += "v 0 0 0\n";
    }
    const Mesh mesh = parsed("a.obj", text);
    const Progress progress{Progress::Listener()};
    progress.cancel();
    for (const MeshFormat format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply}) {
      QVERIFY_EXCEPTION_THROWN(encodeMesh(mesh, moved(mesh, Mat3::Identity(), Vec3(1, 0, 0)), format, progress),
                               Cancelled);
    }
  }
};

const test::Registration<ObjRewriteTest> registration;

}  // namespace pbffd

#include "obj_rewrite_test.moc"
