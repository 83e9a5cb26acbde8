#include "tests/ui/views/open_view.h"

#include "core/mesh/io/mesh_io.h"
#include "core/mesh/rest_mesh.h"
#include "core/project/project_file.h"

#include <QSignalSpy>
#include <QtTest>

#include <cstdlib>

namespace pbffd::ui::test {
namespace {

Project projectWith(const Mesh& mesh, const std::vector<Vec3>& points, double radius) {
  Mesh named = mesh;
  if (named.source.name.empty()) {
    named.source.name = "shape.off";
    named.source.format = MeshFormat::off;
    const DeformedShape shape{named.positions, {}};
    Mesh plain = named;
    plain.source = {};
    named =
        parseMesh(std::make_shared<const std::string>(encodeMesh(plain, shape, MeshFormat::off)), "shape.off");
  }
  Project project = projectOf(std::make_shared<const RestMesh>(std::move(named)));
  for (const Vec3& center : points) {
    ControlPoint point;
    point.id = project.nextId++;
    point.kind = PointKind::interior;
    point.rest = {center, radius * Mat3::Identity()};
    point.pose = point.rest;
    project.controls.levels.back().append(point);
  }
  return project;
}

}  // namespace

OpenView::OpenView(const Mesh& mesh, const std::vector<Vec3>& points, double radius)
    : viewport(document, view, theme) {
  theme.choose(Theme::Choice::dark);
  const QString path = folder_.filePath(QStringLiteral("shape.pbffd"));
  saveProject(path.toStdString(), projectWith(mesh, points, radius));
  viewport.resize(640, 480);
  viewport.show();
  QSignalSpy opened(&document, &Document::opened);
  document.open(path);
  isReady_ = QTest::qWaitForWindowExposed(&viewport) && (opened.count() > 0 || opened.wait(20000));
  frame();
}

const ControlPoint& OpenView::point(PointId id) const {
  const Level& level = document.shown().controls.finest();
  return level[level.find(id).value()];
}

QPoint OpenView::placeOf(PointId id) const {
  const Vec3 at = viewport.projected(point(id).pose.center);
  return QPointF(at.x(), at.y()).toPoint();
}

QImage OpenView::frame() {
  QCoreApplication::processEvents();
  return viewport.picture();
}

int differingPixels(const QImage& first, const QImage& second, int tolerance) {
  if (first.size() != second.size()) {
    return first.width() * first.height();
  }
  int count = 0;
  for (int y = 0; y < first.height(); ++y) {
    for (int x = 0; x < first.width(); ++x) {
      const QRgb a = first.pixel(x, y);
      const QRgb b = second.pixel(x, y);
      const int most = std::max(
          {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
      count += most > tolerance ? 1 : 0;
    }
  }
  return count;
}

}  // namespace pbffd::ui::test
