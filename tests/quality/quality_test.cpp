#include "core/project/edit.h"
#include "core/project/shape.h"
#include "tests/quality/measures.h"
#include "tests/quality/tasks.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <memory>

namespace pbffd {

using test::Deviation;
using test::Quality;
using test::Task;

/// The classic tasks, solved by control points that stand where the program places them by default.
class QualityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    for (Task& task : std::vector<Task>{test::bendTask(), test::twistTask(), test::cactusTask()}) {
      auto mesh = std::make_shared<const RestMesh>(task.mesh);
      scenes_.push_back({std::move(task), apply(projectOf(mesh), Place{}, workspace_).project});
    }
  }

  void posedPointsBendTheMeshNaturally_data() { addTasks(); }
  void posedPointsBendTheMeshNaturally() {
    QFETCH(int, index);
    const Scene& scene = scenes_[static_cast<std::size_t>(index)];
    const Outcome outcome = run(scene, posed(scene));
    report("every point posed", scene, outcome);
    QVERIFY(std::abs(outcome.quality.volumeChange) <= 2.5);
    QVERIFY(outcome.quality.stretch95 <= 1.30);
    QVERIFY(outcome.quality.stretchMax <= 1.6);
    QVERIFY(outcome.quality.jump99 <= (scene.task.name.starts_with("twist") ? 4.5 : 2.5));
    QVERIFY(outcome.deviation.rms <= 1.0);
    QCOMPARE(outcome.quality.folds, 0);
  }

  void framesThatFollowDoAsWellAsPosedOnes_data() { addTasks(); }
  void framesThatFollowDoAsWellAsPosedOnes() {
    QFETCH(int, index);
    const Scene& scene = scenes_[static_cast<std::size_t>(index)];
    const Quality byHand = run(scene, posed(scene)).quality;
    const Outcome following = run(scene, moved(scene, Follow::frames));
    const Outcome positionsOnly = run(scene, moved(scene, Follow::none));
    report("every point moved, frames follow", scene, following);
    report("every point moved, positions only", scene, positionsOnly);
    QVERIFY(following.quality.stretch95 <= 1.15 * byHand.stretch95);
    QVERIFY(following.quality.stretchMax <= 1.15 * std::max(byHand.stretchMax, 1.4));
    QVERIFY(std::abs(following.quality.volumeChange) <= 1.15 * 2.5);
    QVERIFY(following.quality.jump99 <= 0.25 * positionsOnly.quality.jump99);
    QCOMPARE(following.quality.folds, 0);
  }

 private:
  struct Scene {
    Task task;
    Project project;
  };
  struct Outcome {
    Quality quality;
    Deviation deviation;
  };

  void addTasks() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      QTest::newRow(scenes_[i].task.name.c_str()) << static_cast<int>(i);
    }
  }

  static Edit posed(const Scene& scene) {
    Group group;
    for (const ControlPoint& point : scene.project.controls.finest()) {
      SetPose pose;
      pose.point = point.id;
      pose.pose = pbffd::moved(point.rest, scene.task.motion(point.rest.center));
      group.edits.push_back(pose);
    }
    return group;
  }

  static Edit moved(const Scene& scene, Follow follow) {
    Move move;
    move.follow = follow;
    for (const ControlPoint& point : scene.project.controls.finest()) {
      const Vec3& place = point.rest.center;
      move.where.points.push_back(point.id);
      move.by.push_back(applyMap(scene.task.motion(place), place) - place);
    }
    return move;
  }

  Outcome run(const Scene& scene, const Edit& edit) {
    const Project project = apply(scene.project, edit, workspace_).project;
    const Points deformed = deformedShape(project, workspace_.weights).positions;
    const Points& rest = scene.task.mesh.positions;
    return {test::measure(rest, deformed, project.mesh->triangles()),
            test::deviation(deformed, test::naturalShape(scene.task, rest), project.mesh->diagonal())};
  }

  static void report(const char* edit, const Scene& scene, const Outcome& outcome) {
    const auto& [quality, deviation] = outcome;
    qInfo("%s, %s: volume %.2f %%, stretch p95 %.3f, largest %.3f, jump %.2f deg, folds %d, rms %.2f %%", edit,
          scene.task.name.c_str(), quality.volumeChange, quality.stretch95, quality.stretchMax, quality.jump99,
          quality.folds, deviation.rms);
  }

  EditWorkspace workspace_;
  std::vector<Scene> scenes_;
};

const test::Registration<QualityTest> registration;

}  // namespace pbffd

#include "quality_test.moc"
