#include "ui/window/status_line.h"

#include "tests/support/shown_window.h"
#include "tests/support/test_main.h"
#include "tests/ui/document/opened.h"
#include "ui/document/theme.h"

#include <QLabel>
#include <QtTest>

#include <map>

namespace pbffd::test {

class StatusLineTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void keysAreCapsAmongTheWords();
  void hintsGoBeforeFiguresAreCutOff();

 private:
  /// Those that are seen, from the left.
  QStringList labels() const;

  QTemporaryDir folder_;
  std::unique_ptr<ui::Theme> theme_;
  std::unique_ptr<ui::Document> document_;
  std::unique_ptr<ui::StatusLine> line_;
};

void StatusLineTest::init() {
  theme_ = std::make_unique<ui::Theme>();
  document_ = std::make_unique<ui::Document>();
  line_ = std::make_unique<ui::StatusLine>(*document_, *theme_);
  line_->resize(1400, 26);
  QVERIFY(showActive(*line_));
  QVERIFY(openShape(*document_, folder_));
  QVERIFY(document_->perform(
      Move{{std::nullopt, firstPoints(*document_, 2)}, {Vec3(0, 0.2, 0)}, Follow::none, {}}));
  line_->setHint("Moving  [Shift] precise  [X] [Y] axis  [Enter] confirm  [Esc] cancel");
}

void StatusLineTest::cleanup() {
  line_.reset();
  document_.reset();
  theme_.reset();
}

QStringList StatusLineTest::labels() const {
  QCoreApplication::processEvents();
  std::map<int, QString> seen;
  for (const QLabel* label : line_->findChildren<QLabel*>()) {
    if (label->isVisible()) {
      seen[label->mapTo(line_.get(), QPoint()).x()] = label->text();
    }
  }
  QStringList texts;
  for (const auto& [x, text] : seen) {
    texts += text;
  }
  return texts;
}

void StatusLineTest::keysAreCapsAmongTheWords() {
  QCOMPARE(labels().mid(0, 10), QStringList({"Moving", "Shift", "precise", "X", "Y", "axis", "Enter", "confirm",
                                              "Esc", "cancel"}));
  QVERIFY(line_->findChild<QLabel*>("milliseconds")->geometry().right() < line_->width());
}

void StatusLineTest::hintsGoBeforeFiguresAreCutOff() {
  line_->setSimplified(true);
  const QStringList all = labels();
  const auto* last = line_->findChild<QLabel*>("milliseconds");
  for (int width = 1400; width >= 640; width -= 20) {
    line_->resize(width, 26);
    const QStringList seen = labels();
    QVERIFY2(last->geometry().right() < width, qPrintable(QString::number(width)));
    QVERIFY(last->width() >= last->sizeHint().width());
    QCOMPARE(seen.first(), QString("Moving"));
    QVERIFY(seen.contains("cancel") && seen.contains("Esc"));
  }
  QVERIFY(!labels().contains("precise") && !labels().contains("Shift"));
  line_->resize(1400, 26);
  QCOMPARE(labels(), all);
}

const Registration<StatusLineTest> registration;

}  // namespace pbffd::test

#include "status_line_test.moc"
