#pragma once

#include "core/base/file.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/support/shapes.h"
#include "ui/document/document.h"
#include "ui/document/job_runner.h"

#include <QSignalSpy>
#include <QTemporaryDir>

namespace pbffd::test {

/// Long enough for a slow machine that does other things as well.
constexpr int patience = 120000;

/// Writes a mesh as OBJ; returns the path.
inline QString writeShape(const QTemporaryDir& folder, const Mesh& mesh, const QString& name = "shape.obj") {
  const QString path = folder.filePath(name);
  writeFileAtomically(path.toStdString(), encodeMesh(mesh, {mesh.positions, {}}, MeshFormat::obj));
  return path;
}

/// Waits until no job runs or waits any more.
inline bool finishJobs(ui::Document& document) {
  QSignalSpy finished(&document.jobs(), &ui::JobRunner::finished);
  while (document.jobs().isRunning()) {
    if (!finished.wait(patience)) {
      return false;
    }
  }
  return true;
}

/// Few points, so that tests are quick.
inline PlacementOptions fewPoints(int points = 40) {
  PlacementOptions options;
  options.points = points;
  options.levels = 2;
  return options;
}

/// Opens a mesh and waits for its control points.
inline bool openShape(ui::Document& document, const QTemporaryDir& folder, const Mesh& mesh = cylinder()) {
  document.open(writeShape(folder, mesh), fewPoints());
  return finishJobs(document) && document.isOpen();
}

/// The first identifiers of the finest level.
inline std::vector<PointId> firstPoints(const ui::Document& document, int count) {
  std::vector<PointId> points;
  for (const ControlPoint& point : document.shown().controls.finest()) {
    if (static_cast<int>(points.size()) < count) {
      points.push_back(point.id);
    }
  }
  return points;
}

}  // namespace pbffd::test
