#include "tests/support/test_main.h"
#include "tests/ui/document/opened.h"

#include <QtTest>

#include <random>

namespace pbffd::test {

/// Drags and their undos through the document, as the tools make them.
class DocumentDragsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tenThousandDragsAndTheirUndosLeaveNoTrace();
};

void DocumentDragsTest::tenThousandDragsAndTheirUndosLeaveNoTrace() {
  constexpr int drags = 10000;
  constexpr int fewerThanTheHistoryHolds = 200;
  QTemporaryDir folder;
  ui::Document document;
  QVERIFY(openShape(document, folder, cylinder(4.0, 0.5, 12, 10)));
  QVERIFY(document.perform(
      Move{{std::nullopt, firstPoints(document, 3)}, {Vec3(0.1, 1.0 / 3.0, 0)}, Follow::frames, {}}));
  const int entries = document.history().count();
  const ControlSet controls = document.committed().controls;
  const std::vector<float> positions = document.deformation()->positions();
  const std::vector<float> normals = document.deformation()->normals();
  std::mt19937 random(7);
  const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  int moved = 0;
  for (int drag = 0; drag < drags; ++drag) {
    const auto level = static_cast<int>(share() * static_cast<double>(controls.levels.size()));
    const Level& points = controls.levels[static_cast<std::size_t>(level)];
    Move move{{level + 1, {points[static_cast<Index>(share() * points.size())].id}},
              {Vec3::Zero()},
              drag % 2 == 0 ? Follow::frames : Follow::none,
              {}};
    for (int step = 0; step < 2; ++step) {
      move.by = {Vec3(share() - 0.5, share() - 0.5, share() - 0.5)};
      QVERIFY(document.preview(move));
    }
    if (drag % 5 == 4) {
      document.cancelPreview();
    } else {
      document.commitPreview();
    }
    if ((drag + 1) % fewerThanTheHistoryHolds == 0) {
      moved += document.deformation()->positions() == positions ? 0 : 1;
      while (document.history().index() > entries) {
        document.undo();
      }
      QVERIFY(document.committed().controls == controls);
      QVERIFY(document.deformation()->positions() == positions);
      QVERIFY(document.deformation()->normals() == normals);
    }
  }
  QCOMPARE(moved, drags / fewerThanTheHistoryHolds);
}

const Registration<DocumentDragsTest> registration;

}  // namespace pbffd::test

#include "document_drags_test.moc"
