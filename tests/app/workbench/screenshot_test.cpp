#include "core/base/file.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace pbffd::test {

/// The program itself, as run.sh starts it where there is no screen.
class ScreenshotTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void drawsTheWindowWithItsPoints();
  void drawsTheStartPage();
  void aBadFileEndsWithItsReason();
  void wrongUseIsStatusTwo();

 private:
  struct Run {
    int status = -1;
    QString errors;
  };
  static Run run(const QStringList& arguments);
  QTemporaryDir folder_;
};

ScreenshotTest::Run ScreenshotTest::run(const QStringList& arguments) {
  QProcess program;
  program.start(PBFFD_WORKBENCH_PROGRAM, arguments);
  if (!program.waitForFinished(240000) || program.exitStatus() != QProcess::NormalExit) {
    return {};
  }
  return {program.exitCode(), QString::fromUtf8(program.readAllStandardError())};
}

void ScreenshotTest::drawsTheWindowWithItsPoints() {
  const QString mesh = folder_.filePath("bar.obj");
  const Mesh bar = cylinder();
  writeFileAtomically(mesh.toStdString(), encodeMesh(bar, {bar.positions, {}}, MeshFormat::obj));
  const QString picture = folder_.filePath("picture.png");
  const Run result = run({mesh, "--screenshot", picture, "--size", "1300x850", "--theme", "dark"});
  QVERIFY2(result.status == 0, qPrintable(result.errors));
  const QImage image(picture);
  QCOMPARE(image.size(), QSize(1300, 850));
  // In the middle of the view lies the mesh, which is lighter than anything in the dark interface around.
  QSet<QRgb> colours;
  for (int x = 300; x < 950; ++x) {
    colours.insert(image.pixel(x, 340));
  }
  QVERIFY(colours.size() > 50);
}

void ScreenshotTest::drawsTheStartPage() {
  const QString picture = folder_.filePath("start.png");
  QCOMPARE(run({"--screenshot", picture, "--theme", "light"}).status, 0);
  QCOMPARE(QImage(picture).size(), QSize(1600, 1000));
}

void ScreenshotTest::aBadFileEndsWithItsReason() {
  const QString picture = folder_.filePath("none.png");
  const Run result = run({folder_.filePath("missing.obj"), "--screenshot", picture});
  QCOMPARE(result.status, 1);
  QVERIFY(result.errors.contains("missing.obj"));
  QVERIFY(!QFileInfo::exists(picture));
}

void ScreenshotTest::wrongUseIsStatusTwo() {
  const Run result = run({"--bright"});
  QCOMPARE(result.status, 2);
  QVERIFY(result.errors.contains("--bright"));
}

const Registration<ScreenshotTest> registration;

}  // namespace pbffd::test

#include "screenshot_test.moc"
