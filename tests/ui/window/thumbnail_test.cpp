#include "ui/window/thumbnail.h"

#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::test {

class ThumbnailTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theMeshFillsThePicture();
  void nearerSurfacesHideFartherOnes();
  void nothingIsDrawnOfNothing();
};

int opaquePixels(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      count += image.pixelColor(x, y).alpha() > 128 ? 1 : 0;
    }
  }
  return count;
}

QImage pictureOf(const Mesh& mesh) {
  return ui::renderThumbnail(mesh.positions, triangulate(mesh.positions, mesh.faces), {64, 64});
}

void ThumbnailTest::theMeshFillsThePicture() {
  const QImage picture = pictureOf(sphere());
  QCOMPARE(picture.size(), QSize(64, 64));
  const double radius = 0.42 * 64;
  const double expected = 3.14159 * radius * radius;
  QVERIFY(std::abs(opaquePixels(picture) - expected) < 0.05 * expected);
  QCOMPARE(picture.pixelColor(0, 0).alpha(), 0);
}

void ThumbnailTest::nearerSurfacesHideFartherOnes() {
  const QImage alone = pictureOf(sphere());
  const QImage both = pictureOf(merged(sphere(), placedAt(sphere(), 0.5, Vec3::Zero())));
  QCOMPARE(both, alone);
}

void ThumbnailTest::nothingIsDrawnOfNothing() {
  QCOMPARE(opaquePixels(pictureOf(Mesh())), 0);
}

const Registration<ThumbnailTest> registration;

}  // namespace pbffd::test

#include "thumbnail_test.moc"
