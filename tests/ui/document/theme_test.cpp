#include "ui/document/theme.h"

#include "tests/support/test_main.h"
#include "ui/document/icons.h"

#include <QApplication>
#include <QDir>
#include <QIcon>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>

namespace pbffd::test {

using ui::Theme;

/// Contrast of two opaque colours after WCAG 2.1.
double contrast(const QColor& a, const QColor& b) {
  const auto luminance = [](const QColor& color) {
    const auto channel = [](double value) {
      return value <= 0.03928 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * channel(color.redF()) + 0.7152 * channel(color.greenF()) + 0.0722 * channel(color.blueF());
  };
  const double first = luminance(a) + 0.05;
  const double second = luminance(b) + 0.05;
  return std::max(first, second) / std::min(first, second);
}

class ThemeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textIsReadableOnEveryGround();
  void theSheetNamesNoUnknownToken();
  void anUnknownTokenThrows();
  void switchingIsAnnounced();
  void everyIconIsDrawnInItsColour();
};

void ThemeTest::textIsReadableOnEveryGround() {
  Theme theme;
  for (const auto choice : {Theme::Choice::dark, Theme::Choice::light}) {
    theme.choose(choice);
    for (const char* ground : {"window", "panel", "raised", "field", "hover", "accent.bg", "select.bg"}) {
      for (const char* text : {"text", "text.2", "text.3", "accent", "ok", "warn", "error"}) {
        const double ratio = contrast(theme.color(text), theme.color(ground));
        QVERIFY2(ratio >= 4.4, qPrintable(QString("%1 on %2: %3").arg(text, ground).arg(ratio)));
      }
    }
    QVERIFY(contrast(theme.color("accent.text"), theme.color("accent")) >= 4.5);
  }
}

void ThemeTest::theSheetNamesNoUnknownToken() {
  Theme theme;
  for (const auto choice : {Theme::Choice::dark, Theme::Choice::light}) {
    theme.choose(choice);
    const auto left = QRegularExpression("@[a-z.0-9]+@").match(qApp->styleSheet());
    QVERIFY2(!left.hasMatch(), qPrintable(left.captured()));
    const auto files = QRegularExpression(R"(url\(([^)]+)\))").globalMatch(qApp->styleSheet());
    for (auto match = files; match.hasNext();) {
      QVERIFY(QFile::exists(match.next().captured(1)));
    }
  }
}

void ThemeTest::anUnknownTokenThrows() {
  const Theme theme;
  QVERIFY_EXCEPTION_THROWN((void)theme.color("no.such.token"), std::out_of_range);
}

void ThemeTest::switchingIsAnnounced() {
  Theme theme;
  theme.choose(Theme::Choice::dark);
  QSignalSpy changed(&theme, &Theme::changed);
  const QColor dark = theme.color("panel");
  theme.choose(Theme::Choice::light);
  QCOMPARE(changed.count(), 1);
  QVERIFY(!theme.isDark());
  QVERIFY(theme.color("panel") != dark);
  QCOMPARE(QApplication::palette().color(QPalette::Window), theme.color("panel"));
}

void ThemeTest::everyIconIsDrawnInItsColour() {
  Theme theme;
  theme.choose(Theme::Choice::dark);
  const QStringList names = QDir(":/icons").entryList({"*.svg"});
  QVERIFY(names.size() > 40);
  for (const QString& name : names) {
    const QImage image =
        ui::makeIcon(theme, QFileInfo(name).completeBaseName(), {"error", "accent"}).pixmap(40, 40).toImage();
    int drawn = 0;
    bool hasColour = false;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        drawn += image.pixelColor(x, y).alpha() > 128 ? 1 : 0;
        hasColour |= image.pixelColor(x, y) == theme.color("error");
      }
    }
    QVERIFY2(drawn > 20, qPrintable(name));
    QVERIFY2(hasColour || name.startsWith("pbffd"), qPrintable(name));
  }
}

const Registration<ThemeTest> registration;

}  // namespace pbffd::test

#include "theme_test.moc"
