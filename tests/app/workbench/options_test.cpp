#include "app/workbench/options.h"

#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::test {

using workbench::Options;
using workbench::parseOptions;

class OptionsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingMeansTheStartPage();
  void allOptionsAreTaken();
  void valuesMayFollowAnEqualsSign();
  void nonsenseIsRefused_data();
  void nonsenseIsRefused();
};

void OptionsTest::nothingMeansTheStartPage() {
  const Options options = parseOptions({});
  QVERIFY(options.file.isEmpty() && options.screenshot.isEmpty());
  QCOMPARE(options.size, QSize(1600, 1000));
  QVERIFY(!options.hasTheme && !options.hasSize);
}

void OptionsTest::allOptionsAreTaken() {
  const Options options =
      parseOptions({"--theme", "light", "cow.obj", "--screenshot", "out.png", "--size", "1280x800"});
  QCOMPARE(options.file, QString("cow.obj"));
  QCOMPARE(options.screenshot, QString("out.png"));
  QCOMPARE(options.size, QSize(1280, 800));
  QVERIFY(options.theme == ui::Theme::Choice::light);
}

void OptionsTest::valuesMayFollowAnEqualsSign() {
  const Options options = parseOptions({"--theme=dark", "--size=800x600", "--screenshot=a.png"});
  QVERIFY(options.theme == ui::Theme::Choice::dark);
  QCOMPARE(options.size, QSize(800, 600));
  QCOMPARE(options.screenshot, QString("a.png"));
}

void OptionsTest::nonsenseIsRefused_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::newRow("unknown option") << QStringList{"--bright"};
  QTest::newRow("unknown theme") << QStringList{"--theme", "blue"};
  QTest::newRow("no value") << QStringList{"--size"};
  QTest::newRow("no size") << QStringList{"--size", "big"};
  QTest::newRow("two files") << QStringList{"a.obj", "b.obj"};
}

void OptionsTest::nonsenseIsRefused() {
  QFETCH(QStringList, arguments);
  QVERIFY_EXCEPTION_THROWN(parseOptions(arguments), workbench::UsageError);
}

const Registration<OptionsTest> registration;

}  // namespace pbffd::test

#include "options_test.moc"
