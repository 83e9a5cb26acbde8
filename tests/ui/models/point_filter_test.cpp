#include "ui/models/point_filter.h"

#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::test {

using ui::PointFilter;

class PointFilterTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void acceptsWhatItSays_data();
  void acceptsWhatItSays();
};

void PointFilterTest::acceptsWhatItSays_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<bool>("accepted");
  QTest::newRow("empty") << "" << true;
  QTest::newRow("part of the name") << "eck" << true;
  QTest::newRow("any case") << "NECK" << true;
  QTest::newRow("another name") << "tail" << false;
  QTest::newRow("number") << "23" << true;
  QTest::newRow("part of the number") << "2" << false;
  QTest::newRow("kind") << "kind:exterior" << true;
  QTest::newRow("part of the kind") << "kind:ext" << true;
  QTest::newRow("another kind") << "kind:interior" << false;
  QTest::newRow("moved") << "moved" << true;
  QTest::newRow("disabled") << "disabled" << false;
  QTest::newRow("all words") << "neck moved kind:ext" << true;
  QTest::newRow("one word not") << "neck disabled" << false;
}

void PointFilterTest::acceptsWhatItSays() {
  QFETCH(QString, text);
  QFETCH(bool, accepted);
  ControlPoint point;
  point.id = 23;
  point.name = "Neck";
  point.kind = PointKind::exterior;
  point.pose.center = Vec3(0, 1, 0);
  QCOMPARE(PointFilter(text).accepts(point), accepted);
}

const Registration<PointFilterTest> registration;

}  // namespace pbffd::test

#include "point_filter_test.moc"
