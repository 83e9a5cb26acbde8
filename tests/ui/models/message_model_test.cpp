#include "ui/models/message_model.h"

#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::test {

using ui::MessageModel;
using ui::Severity;

class MessageModelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theNewestIsLast();
  void theOldestLeaveFirst();
  void clearLeavesNone();
};

void MessageModelTest::theNewestIsLast() {
  MessageModel model;
  model.add(Severity::info, "one");
  model.add(Severity::error, "two");
  QCOMPARE(model.rowCount(), 2);
  QCOMPARE(model.index(1).data().toString(), QString("two"));
  QCOMPARE(model.index(1).data(MessageModel::severityRole).toInt(), static_cast<int>(Severity::error));
  QVERIFY(model.toText().endsWith("two"));
  QCOMPARE(model.toText().count(u'\n'), 1);
}

void MessageModelTest::theOldestLeaveFirst() {
  MessageModel model;
  for (int i = 0; i < 1000; ++i) {
    model.add(Severity::info, QString::number(i));
  }
  QCOMPARE(model.rowCount(), 500);
  QCOMPARE(model.index(0).data().toString(), QString("500"));
}

void MessageModelTest::clearLeavesNone() {
  MessageModel model;
  model.add(Severity::info, "one");
  model.clear();
  QCOMPARE(model.rowCount(), 0);
}

const Registration<MessageModelTest> registration;

}  // namespace pbffd::test

#include "message_model_test.moc"
