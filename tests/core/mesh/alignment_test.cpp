#include "core/mesh/alignment.h"
#include "core/base/error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

namespace pbffd {
namespace {

/// A body without any symmetry: a fork with a ball stuck on.
Mesh body() {
  return test::merged(test::fork(), test::placedAt(test::sphere(12, 20), 0.6, Vec3(1.0, 0.4, 0.7)));
}

Similarity someSimilarity(double angle) {
  return {0.037, Eigen::AngleAxisd(angle, Vec3(1.0, -2.0, 0.5).normalized()).matrix(), Vec3(12.0, -3.0, 7.0)};
}

Points moved(const Points& points, const AffineMap& map) {
  return (points * map.leftCols<3>().transpose()).rowwise() + map.col(3).transpose();
}

double largestMiss(const Points& points, const AffineMap& map, const Points& expected) {
  return (moved(points, map) - expected).rowwise().norm().maxCoeff();
}

}  // namespace

class AlignmentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void fitGivesBackTheSimilarityOfItsPairs() {
    const Points from = body().positions;
    const Similarity similarity = someSimilarity(2.0);
    const Similarity fit = fitSimilarity(from, moved(from, similarity.map()),
                                         std::vector<double>(static_cast<std::size_t>(from.rows()), 0.5));
    QVERIFY(std::abs(fit.scale - similarity.scale) < 1e-14);
    QVERIFY((fit.rotation - similarity.rotation).norm() < 1e-12);
    QVERIFY((fit.translation - similarity.translation).norm() < 1e-12);
    QVERIFY((composed(fit.inverse(), fit.map()) - identityMap()).norm() < 1e-12);
  }

  void sameMeshIsFoundAtEveryTurn_data() {
    QTest::addColumn<double>("angle");
    for (const double angle : {0.0, 0.4, 1.3, 2.2, 3.1}) {
      QTest::addRow("%g", angle) << angle;
    }
  }
  void sameMeshIsFoundAtEveryTurn() {
    QFETCH(double, angle);
    const RestMesh rest(body());
    const Points other = moved(rest.positions(), someSimilarity(angle).map());
    const Alignment alignment = alignSimilar(other, rest);
    QVERIFY(largestMiss(other, alignment.toRest.map(), rest.positions()) < 1e-9 * rest.diagonal());
    QVERIFY(alignment.meanDistance < 1e-9 * rest.diagonal());
  }

  void everyThirdVertexIsEnough() {
    const RestMesh rest(body());
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = 0; i < rest.vertexCount(); i += 3) {
      rows.push_back(i);
    }
    const Points expected = rest.positions()(rows, Eigen::all);
    const Points other = moved(expected, someSimilarity(1.3).map());
    const Alignment alignment = alignSimilar(other, rest);
    QVERIFY(largestMiss(other, alignment.toRest.map(), expected) < 1e-6 * rest.diagonal());
  }

  void fewStraysDoNoHarm() {
    const RestMesh rest(body());
    Points other = moved(rest.positions(), someSimilarity(1.3).map());
    for (Eigen::Index i = 0; i < other.rows(); i += 100) {
      other.row(i) += Eigen::RowVector3d(0.05, 0.02 * static_cast<double>(i % 7), -0.03);
    }
    other(0, 0) = std::numeric_limits<double>::quiet_NaN();
    const AffineMap map = alignSimilar(other, rest).toRest.map();
    for (Eigen::Index i = 1; i < 100; ++i) {
      QVERIFY((applyMap(map, other.row(i).transpose()) - rest.positions().row(i).transpose()).norm() <
              1e-3 * rest.diagonal());
    }
  }

  void symmetricShapeKeepsItsTurn() {
    const RestMesh rest(test::sphere());
    const Points other = 3.0 * rest.positions();
    const Alignment alignment = alignSimilar(other, rest);
    QVERIFY((alignment.toRest.map() - makeMap(Mat3::Identity() / 3.0, Vec3::Zero())).norm() < 1e-9);
  }

  void flatShapeIsFound() {
    Mesh sheet = test::sheet();
    sheet.positions.col(1) *= 0.3;
    const RestMesh rest(sheet);
    const Points other = moved(rest.positions(), someSimilarity(0.2).map());
    QVERIFY(alignSimilar(other, rest).meanDistance < 1e-9 * rest.diagonal());
  }

  void sameInputGivesTheSameBits() {
    const RestMesh rest(body());
    const Points other = moved(rest.positions(), someSimilarity(0.9).map());
    QVERIFY(alignSimilar(other, rest).toRest.map() == alignSimilar(other, rest).toRest.map());
  }

  void pointsOnALineAreAnError() {
    const RestMesh rest(body());
    Points line = Points::Zero(20, 3);
    line.col(0).setLinSpaced(0.0, 1.0);
    QVERIFY_EXCEPTION_THROWN(alignSimilar(line, rest), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(alignSimilar(Points::Ones(5, 3), rest), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(alignSimilar(Points(0, 3), rest), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(alignSimilar(rest.positions(), RestMesh(Mesh())), InvalidInput);
  }

  void cancelledWorkThrows() {
    const RestMesh rest(body());
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(alignSimilar(rest.positions(), rest, progress), Cancelled);
  }
};

const test::Registration<AlignmentTest> registration;

}  // namespace pbffd

#include "alignment_test.moc"
