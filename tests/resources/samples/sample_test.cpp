#include "resources/samples/generator/sample.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>

namespace pbffd::samples {

class SampleTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    all_ = {makeCreature(), makeFigure(), makeHand(), makeBracket(), makeVase(), makeBar()};
  }

  void everySampleIsOneSoundSurface() {
    for (const auto& sample : all_) {
      requireSound(sample);
      const auto corners = sample.faces.vertices().size();
      QCOMPARE(sample.normalOfCorner.size(), corners);
      QCOMPARE(sample.textureOfCorner.size(), corners);
      QCOMPARE(sample.groupOfFace.size(), static_cast<std::size_t>(sample.faces.size()));
      QVERIFY(sample.positions.allFinite());
      QVERIFY(sample.textures.minCoeff() >= 0.0 && sample.textures.maxCoeff() <= 1.0);
      QVERIFY((sample.normals.rowwise().norm().array() - 1.0).abs().maxCoeff() < 1e-5);
    }
  }

  void creatureHasAboutTenThousandTriangles() {
    const Sample& creature = all_.front();
    QVERIFY(creature.faces.size() > 8'000 && creature.faces.size() < 13'000);
    QCOMPARE(static_cast<Index>(creature.faces.vertices().size()), 3 * creature.faces.size());
    QVERIFY(std::abs(creature.positions.col(1).minCoeff()) < 0.02);  // it stands on the ground
  }

  void normalsPointOutwards() {
    for (const auto& sample : all_) {
      if (!sample.isClosed) {
        continue;
      }
      double volume = 0.0;
      for (Index f = 0; f < sample.faces.size(); ++f) {
        const auto face = sample.faces[f];
        const Vec3 a = sample.positions.row(face[0]);
        for (std::size_t c = 1; c + 1 < face.size(); ++c) {
          const Vec3 b = sample.positions.row(face[c]);
          volume += a.cross(b).dot(sample.positions.row(face[c + 1]).transpose()) / 6.0;
        }
      }
      QVERIFY2(volume > 0.0, sample.name.c_str());
    }
  }

  void bytesDoNotDependOnTheThreads() {
    const ThreadLimit limit(1);
    QVERIFY(toObj(makeHand()) == toObj(all_[2]));
  }

  void unsoundSurfaceIsRefused() {
    Sample open = makeBar();
    Polygons faces;
    for (Index f = 1; f < open.faces.size(); ++f) {
      faces.add(open.faces[f]);
    }
    open.faces = faces;
    QVERIFY_EXCEPTION_THROWN(requireSound(open), InvalidInput);
  }

 private:
  std::vector<Sample> all_;
};

const test::Registration<SampleTest> registration;

}  // namespace pbffd::samples

#include "sample_test.moc"
