#include "core/base/file.h"
#include "core/project/edit_json.h"
#include "core/project/project_file.h"
#include "core/project/shape.h"
#include "tests/support/test_main.h"
#include "tests/ui/window/open_window.h"

namespace pbffd::test {

/// The session of the first issue, with the mouse and the keys of a user: open a figure, raise an arm with
/// three control points, undo twice, redo, save, quit, open again, export. The same edits run by the core,
/// as `pbffd edit` runs them, give the same bytes.
class SessionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sculptSaveReopenExport();

 private:
  static std::vector<PointId> armPoints(OpenWindow& open);
  static void type(OpenWindow& open, const QString& keys);
  static std::string reference(const QString& mesh, const std::vector<PointId>& points);
};

/// Three points near the end of an arm that can be picked where they are.
std::vector<PointId> SessionTest::armPoints(OpenWindow& open) {
  const Level& level = open.window.document().shown().controls.finest();
  std::vector<std::pair<double, PointId>> byReach;
  for (const ControlPoint& point : level) {
    const auto picked = open.window.viewport().pointsAt(open.placeOf(point.id));
    const QWidget* above = open.window.viewport().surface()->childAt(open.placeOf(point.id));
    if (!picked.empty() && picked.front() == point.id && above == nullptr && point.rest.center.y() > 0.0) {
      byReach.emplace_back(-point.rest.center.x(), point.id);
    }
  }
  std::sort(byReach.begin(), byReach.end());
  std::vector<PointId> points;
  for (std::size_t i = 0; i < 3 && i < byReach.size(); ++i) {
    points.push_back(byReach[i].second);
  }
  return points;
}

void SessionTest::type(OpenWindow& open, const QString& keys) {
  QTest::keyClicks(open.window.viewport().surface(), keys);
  QTest::keyClick(open.window.viewport().surface(), Qt::Key_Return);
}

/// The same steps by the core alone, from the file, through the JSON of the edits.
std::string SessionTest::reference(const QString& mesh, const std::vector<PointId>& points) {
  const QString ids = QString("[%1, %2, %3]").arg(points[0]).arg(points[1]).arg(points[2]);
  const QString edits = QString(R"([{"place": {}},
      {"move": {"level": 3, "points": %1, "by": [0, 0.5, 0]}},
      {"move": {"level": 3, "points": %1, "by": [0, 0, 0.25]}}])")
                            .arg(ids);
  EditWorkspace workspace;
  Project project =
      projectOf(std::make_shared<const RestMesh>(readMesh(std::filesystem::path(mesh.toStdString()))));
  for (const Edit& edit : parseEdits(edits.toStdString(), "session")) {
    project = apply(project, edit, workspace).project;
  }
  return encodeMesh(project.mesh->mesh(), deformedShape(project, workspace.weights), MeshFormat::obj);
}

void SessionTest::sculptSaveReopenExport() {
  QTemporaryDir folder;
  const QString mesh = writeShape(folder, fork(0.6), "figure.obj");
  const QString saved = folder.filePath("raised.pbffd");
  const QString exported = folder.filePath("raised.obj");
  std::vector<PointId> points;
  {
    OpenWindow open;
    QVERIFY(open.isReady);
    ui::Document& document = open.window.document();
    OpenWindow::answerFileDialog(mesh);
    open.key(Qt::Key_O, Qt::ControlModifier);
    QVERIFY(finishJobs(document));
    QVERIFY(document.isOpen());
    QCOMPARE(document.shown().controls.levels.size(), std::size_t{3});
    QWidget* view = open.window.viewport().surface();
    QTest::qWait(200);

    points = armPoints(open);
    QCOMPARE(points.size(), std::size_t{3});
    QTest::mouseClick(view, Qt::LeftButton, {}, open.placeOf(points[0]));
    QTest::mouseClick(view, Qt::LeftButton, Qt::ShiftModifier, open.placeOf(points[1]));
    QTest::mouseClick(view, Qt::LeftButton, Qt::ShiftModifier, open.placeOf(points[2]));
    QCOMPARE(document.selection().points(), points);

    type(open, "gy0.5");
    type(open, "gz0.25");
    type(open, "gx0.1");
    QCOMPARE(document.history().count(), 4);
    open.key(Qt::Key_Z, Qt::ControlModifier);
    open.key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.history().index(), 2);
    open.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(document.history().index(), 3);
    QVERIFY(open.window.windowTitle().contains("(changed)"));

    OpenWindow::answerFileDialog(saved);
    open.key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(QFileInfo::exists(saved));
    QVERIFY(!open.window.isWindowModified());
    QVERIFY(open.window.windowTitle().startsWith("raised.pbffd"));
    // Nothing to ask: everything is saved.
    QVERIFY(open.window.close());
  }
  {
    OpenWindow open;
    QVERIFY(open.isReady);
    QVERIFY(open.open(saved));
    QVERIFY(open.window.document().isOpen());
    OpenWindow::answerFileDialog(exported);
    open.key(Qt::Key_E, Qt::ControlModifier);
    QVERIFY(finishJobs(open.window.document()));
    QVERIFY(open.window.close());
  }
  QCOMPARE(readFile(exported.toStdString()), reference(mesh, points));
  QVERIFY(readFile(exported.toStdString()) != readFile(mesh.toStdString()));
}

const Registration<SessionTest> registration;

}  // namespace pbffd::test

#include "session_test.moc"
