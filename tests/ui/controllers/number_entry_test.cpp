#include "ui/controllers/number_entry.h"
#include "tests/support/test_main.h"
#include "ui/controllers/axis_lock.h"

#include <QtTest>

namespace pbffd::ui {

class NumberEntryTest : public QObject {
  Q_OBJECT

  static NumberEntry typed(const QString& text) {
    NumberEntry entry;
    for (const QChar character : text) {
      entry.type(character);
    }
    return entry;
  }

 private Q_SLOTS:
  void sumsAreWorkedOut() {
    QCOMPARE(typed("1.2*3").value(0).value(), 1.2 * 3);
    QCOMPARE(typed("-(2+0.5)/5").value(0).value(), -0.5);
    QVERIFY(!typed("1.2*").value(0));
    QVERIFY(!typed("1/0").value(0));
  }

  void lettersAreNoNumbers() {
    QVERIFY(typed("gx").isEmpty());
    QVERIFY(!NumberEntry::accepts('e'));
  }

  void tabGoesRoundTheNumbers() {
    NumberEntry entry = typed("1");
    entry.next();
    entry.type('2');
    entry.next();
    entry.next();
    entry.type('5');
    QCOMPARE(entry.value(0).value(), 15.0);
    QCOMPARE(entry.value(1).value(), 2.0);
    QCOMPARE(entry.value(2).value(), 0.0);
  }

  void erasingGoesBackToTheNumberBefore() {
    NumberEntry entry = typed("12");
    entry.next();
    entry.type('3');
    entry.erase();
    entry.erase();
    entry.erase();
    QCOMPARE(entry.text(0), QStringLiteral("1"));
    entry.erase();
    QVERIFY(entry.isEmpty());
    entry.erase();
    QVERIFY(entry.isEmpty());
  }

  void fewerNumbersDropTheOthers() {
    NumberEntry entry = typed("1");
    entry.next();
    entry.type('2');
    entry.setCount(1);
    QCOMPARE(entry.field(), 0);
    QCOMPARE(entry.value(0).value(), 1.0);
    QVERIFY(entry.text(1).isEmpty());
  }

  void axisKeysGoGlobalLocalFree() {
    AxisLock lock;
    lock = lock.afterKey(1, false);
    QCOMPARE(lock, (AxisLock{AxisLock::Kind::axis, 1, AxisLock::Space::global}));
    lock = lock.afterKey(1, false);
    QCOMPARE(lock, (AxisLock{AxisLock::Kind::axis, 1, AxisLock::Space::local}));
    lock = lock.afterKey(1, false);
    QCOMPARE(lock.kind, AxisLock::Kind::free);
    lock = lock.afterKey(2, true);
    QCOMPARE(lock, (AxisLock{AxisLock::Kind::plane, 2, AxisLock::Space::global}));
    lock = lock.afterKey(0, false);
    QCOMPARE(lock, (AxisLock{AxisLock::Kind::axis, 0, AxisLock::Space::global}));
    // A drag of the gizmo's own arrow: the key of the same axis means the global one.
    lock = lockOf(GizmoPart::axisZ).afterKey(2, false);
    QCOMPARE(lock, (AxisLock{AxisLock::Kind::axis, 2, AxisLock::Space::global}));
  }
};

const pbffd::test::Registration<NumberEntryTest> registration;

}  // namespace pbffd::ui

#include "number_entry_test.moc"
