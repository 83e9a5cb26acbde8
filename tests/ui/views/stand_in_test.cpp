#include "ui/views/stand_in.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pbffd::ui {
namespace {

/// A sheet whose vertices lie up to so far above or below it, one here, the next there.
std::shared_ptr<const RestMesh> roughSheet(double roughness) {
  Mesh mesh = pbffd::test::triangulated(pbffd::test::sheet(200));
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    mesh.positions(v, 2) = roughness * std::sin(12.9898 * v);
  }
  return std::make_shared<const RestMesh>(std::move(mesh));
}

std::vector<float> slotPositions(const RestMesh& mesh) {
  std::vector<float> positions;
  for (const Index vertex : mesh.mortonOrder()) {
    for (int axis = 0; axis < 3; ++axis) {
      positions.push_back(static_cast<float>(mesh.positions()(vertex, axis)));
    }
  }
  return positions;
}

/// How far normals lean from up at most, as sines; 3 numbers a normal.
double mostLean(const std::vector<float>& normals) {
  double most = 0.0;
  for (std::size_t i = 0; i + 2 < normals.size(); i += 3) {
    most = std::max(most, std::hypot(static_cast<double>(normals[i]), static_cast<double>(normals[i + 1])));
  }
  return most;
}

/// Those of a stand-in that follows the mesh as it is.
std::vector<float> normalsOfStandIn(const std::shared_ptr<const RestMesh>& mesh) {
  StandIn standIn;
  QSignalSpy ready(&standIn, &StandIn::ready);
  standIn.build(mesh, 4000);
  if (ready.isEmpty() && !ready.wait(20000)) {
    return {};
  }
  standIn.follow(slotPositions(*mesh));
  return *standIn.buffers().normals;
}

}  // namespace

class StandInTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void flatIsFlat() {
    const std::vector<float> normals = normalsOfStandIn(roughSheet(0.0));
    QVERIFY(normals.size() > 3000);
    QVERIFY(mostLean(normals) < 1e-6);
  }

  void aRoughSurfaceHasNoDarkSpecks() {
    const double most = mostLean(normalsOfStandIn(roughSheet(0.01)));
    QVERIFY2(most < 0.5, QByteArray::number(most).constData());
  }
};

const pbffd::test::Registration<StandInTest> registration;

}  // namespace pbffd::ui

#include "stand_in_test.moc"
