#include "core/project/edit_json.h"
#include "core/project/shape.h"
#include "tests/app/cli/cli_support.h"
#include "tests/support/test_main.h"
#include "tests/ui/window/open_window.h"
#include "ui/models/history_model.h"

#include <Eigen/Geometry>
#include <numbers>

namespace pbffd::test {

/// The story of the paper's Figure 7 with the keys of a user: a neck elongated on the coarsest level, a snout
/// stretched on the finest, then the coarsest bent again. The snout is carried along; all of it can be undone;
/// and the command line does the same to the last bit.
class LevelStoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void neckThenSnoutThenNeck();

 private:
  static std::vector<PointId> pointsBeyond(const ui::Document& document, int level, double x);
  static void sculpt(OpenWindow& open, int level, double beyond, const QString& keys);
  static void requireCarriedDetail(const Project& placed, const std::vector<Edit>& edits);
  static void requireTheSameByCommandLine(const std::string& mesh, const std::string& exported,
                                          const QString& edits);
};

/// A bar along x: the neck ends at 2.4, the snout begins at 3.6.
constexpr double headBegins = 2.4;
constexpr double snoutBegins = 3.6;
constexpr double bend = 40.0;

std::vector<PointId> LevelStoryTest::pointsBeyond(const ui::Document& document, int level, double x) {
  std::vector<PointId> points;
  for (const ControlPoint& point : document.shown().controls.levels[static_cast<std::size_t>(level - 1)]) {
    if (point.rest.center.x() > x) {
      points.push_back(point.id);
    }
  }
  return points;
}

void LevelStoryTest::sculpt(OpenWindow& open, int level, double beyond, const QString& keys) {
  QWidget* view = open.window.viewport().surface();
  ui::Document& document = open.window.document();
  view->setFocus();
  QTest::keyClick(view, static_cast<Qt::Key>(Qt::Key_0 + level));
  QCOMPARE(document.selection().level(), level);
  document.selection().replace(pointsBeyond(document, level, beyond));
  const int entries = document.history().count();
  QTest::keyClicks(view, keys);
  QTest::keyClick(view, Qt::Key_Return);
  QCOMPARE(document.history().count(), entries + 1);
}

/// What the snout adds to the shape keeps its size under the last edit, and turns with the head.
void LevelStoryTest::requireCarriedDetail(const Project& placed, const std::vector<Edit>& edits) {
  const auto shapeAfter = [&](const std::vector<Edit>& some) {
    EditWorkspace workspace;
    return deformedShape(applyAll(placed, some, workspace).project, workspace.weights).positions;
  };
  const Points before = shapeAfter({edits[0], edits[1]}) - shapeAfter({edits[0]});
  const Points after = shapeAfter(edits) - shapeAfter({edits[0], edits[2]});
  const Mat3 turn = Eigen::AngleAxisd(bend * std::numbers::pi / 180.0, Vec3::UnitY()).toRotationMatrix();
  Index tip = 0;
  before.rowwise().norm().maxCoeff(&tip);
  const Vec3 expected = turn * before.row(tip).transpose();
  QVERIFY(expected.norm() > 0.2);
  const double miss = (after.row(tip).transpose() - expected).norm() / expected.norm();
  qInfo("the detail is carried to %.2f %%", 100.0 * miss);
  QVERIFY(miss < 0.05);
}

void LevelStoryTest::requireTheSameByCommandLine(const std::string& mesh, const std::string& exported,
                                                 const QString& edits) {
  const CommandFolder folder;
  const QString source = folder.write("bar.obj", QByteArray::fromStdString(mesh));
  const QString project = folder.path("bar.pbffd");
  const auto done = [](const QStringList& arguments, const QByteArray& input = {}) {
    const CommandResult result = runPbffd(arguments, input);
    QVERIFY2(result.status == 0, result.errors);
  };
  done({"place", source, "-o", project});
  done({"edit", project, "--edits", "-", "-o", project}, edits.toUtf8());
  done({"export", project, "-o", folder.path("story.obj")});
  QCOMPARE(folder.read("story.obj"), QByteArray::fromStdString(exported));
}

void LevelStoryTest::neckThenSnoutThenNeck() {
  OpenWindow open;
  QVERIFY(open.isReady);
  const QString mesh = writeShape(open.folder, cylinder());
  QVERIFY(open.open(mesh));
  ui::Document& document = open.window.document();
  const Project placed = document.committed();

  sculpt(open, 1, headBegins, "gx1.5");
  sculpt(open, 3, snoutBegins, "gz0.4");
  sculpt(open, 1, headBegins, QString("ry%1").arg(bend));
  const ControlSet sculpted = document.committed().controls;

  QStringList steps;
  const ui::HistoryModel history(document);
  for (int row = 2; row <= document.history().count(); ++row) {
    steps += history.editJson(row);
  }
  const QString edits = "[" + steps.join(",") + "]";
  requireCarriedDetail(placed, parseEdits(edits.toStdString(), "story"));

  for (int step = 0; step < 3; ++step) {
    open.key(Qt::Key_Z, Qt::ControlModifier);
  }
  QVERIFY(document.committed().controls == placed.controls);
  for (int step = 0; step < 3; ++step) {
    open.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  }
  QVERIFY(document.committed().controls == sculpted);

  const QString exported = open.folder.filePath("story.obj");
  OpenWindow::answerFileDialog(exported);
  open.key(Qt::Key_E, Qt::ControlModifier);
  QVERIFY(finishJobs(document));
  requireTheSameByCommandLine(readFile(mesh.toStdString()), readFile(exported.toStdString()), edits);
}

const Registration<LevelStoryTest> registration;

}  // namespace pbffd::test

#include "level_story_test.moc"
