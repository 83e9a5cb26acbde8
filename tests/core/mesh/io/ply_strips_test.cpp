#include "core/mesh/io/ply_strips.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::io {

class PlyStripsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyOtherTriangleIsTurnedOver() {
    Polygons faces;
    StripTriangles().add(std::vector<Index>{0, 1, 2, 3, 4}, faces);
    QCOMPARE(faces.vertices(), (std::vector<Index>{0, 1, 2, 2, 1, 3, 2, 3, 4}));
  }

  void aNewStripBeginsUnturned() {
    Polygons faces;
    StripTriangles().add(std::vector<Index>{-1, 0, 1, 2, 3, -1, 4, 5, -1, 6, 7, 8, -1}, faces);
    QCOMPARE(faces.vertices(), (std::vector<Index>{0, 1, 2, 2, 1, 3, 6, 7, 8}));
  }

  void joiningTrianglesAreCountedAndLeftOut() {
    Polygons faces;
    StripTriangles triangles;
    triangles.add(std::vector<Index>{0, 1, 2, 2, 3, 3, 4, 5}, faces);
    QCOMPARE(faces.vertices(), (std::vector<Index>{0, 1, 2, 4, 3, 5}));
    QCOMPARE(triangles.joining(), std::size_t{4});
  }

  void shortStripsHaveNoTriangles() {
    Polygons faces;
    StripTriangles().add(std::vector<Index>{0, 1}, faces);
    StripTriangles().add(std::vector<Index>{}, faces);
    QVERIFY(faces.empty());
  }
};

const test::Registration<PlyStripsTest> registration;

}  // namespace pbffd::io

#include "ply_strips_test.moc"
