// What the document does off the UI thread: reading, placing, exporting.

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/io/export_losses.h"
#include "core/project/shape.h"
#include "ui/document/change_project.h"
#include "ui/document/document.h"
#include "ui/document/job_runner.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QLocale>

namespace pbffd::ui {
namespace {

std::filesystem::path pathOf(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

bool isProjectFile(const QString& path) {
  return QFileInfo(path).suffix().compare("pbffd", Qt::CaseInsensitive) == 0;
}

/// Everything that the views ask of a mesh, so that the UI thread finds it made.
void prepare(const RestMesh& mesh, const Progress& progress) {
  progress.report("Preparing the mesh");
  mesh.triangles();
  progress.throwIfCancelled();
  mesh.normals();
  mesh.mortonOrder();
  progress.throwIfCancelled();
  mesh.topology();
  progress.throwIfCancelled();
}

/// Before what is open makes room for it: a mesh that takes no points is of no use here.
void refuseUnplaceable(const RestMesh& mesh, const QString& path) {
  try {
    requirePlaceable(mesh);
  } catch (const InvalidInput& error) {
    throw InvalidInput(QObject::tr("Could not open %1. %2")
                           .arg(QFileInfo(path).fileName(), QString::fromUtf8(error.what()))
                           .toStdString());
  }
}

QString counted(Index count, const QString& one, const QString& many) {
  return QString("%1 %2").arg(QLocale(QLocale::English).toString(count), count == 1 ? one : many);
}

QString openedMessage(const QString& name, const RestMesh& mesh) {
  const Topology& topology = mesh.topology();
  return QObject::tr("Opened %1: %2, %3, %4, %5.")
      .arg(name, counted(mesh.vertexCount(), "vertex", "vertices"),
           counted(mesh.triangles().size(), "triangle", "triangles"),
           topology.isClosed ? QObject::tr("closed") : QObject::tr("open"),
           counted(topology.components, "part", "parts"));
}

}  // namespace

struct Document::Opened {
  Project project;
  ProjectExtras extras;
  std::vector<std::string> remarks;
  QString path;
  bool isProject = false;
  std::shared_ptr<EditWorkspace> workspace = std::make_shared<EditWorkspace>();
  ReadyDeformation ready;
};

Document::ReadyDeformation Document::readyDeformation(const Project& project, EditWorkspace& workspace,
                                                      const Progress& progress) {
  auto weights = workspace.weights.parameterization(project.mesh, project.controls, progress);
  auto deformation = std::make_unique<LiveDeformation>(project.mesh, weights);
  deformation->update(mapsOf(project.controls, project.controls.finest()));
  progress.throwIfCancelled();
  return {std::move(weights), std::move(deformation)};
}

Document::Opened Document::read(const QString& path, const Progress& progress) {
  Opened file;
  file.path = path;
  file.isProject = isProjectFile(path);
  if (file.isProject) {
    LoadedProject loaded = loadProject(pathOf(path), progress);
    file.project = std::move(loaded.project);
    file.extras = std::move(loaded.extras);
    file.remarks = std::move(loaded.remarks);
  } else {
    file.project = projectOf(std::make_shared<const RestMesh>(readMesh(pathOf(path), progress)));
    refuseUnplaceable(*file.project.mesh, path);
  }
  prepare(*file.project.mesh, progress);
  file.ready = readyDeformation(file.project, *file.workspace, progress);
  return file;
}

void Document::open(const QString& path, const PlacementOptions& options) {
  jobs_->cancel("place");
  jobs_->start({"open", tr("Opening %1").arg(QFileInfo(path).fileName()),
                [this, path, options](const Progress& progress) -> JobRunner::Deliver {
                  const auto file = std::make_shared<Opened>(read(path, progress));
                  return [this, file, options] {
                    adopt(*file);
                    if (!file->isProject) {
                      performInBackground(Place{.options = options, .keepEdits = false, .symmetric = {}});
                    }
                  };
                }});
}

void Document::adopt(Opened& file) {
  cancelPreview();
  history_->clear();
  shownBefore_.reset();
  committed_ = file.project;
  ++revision_;
  workspace_ = file.workspace;
  extras_ = file.extras;
  path_ = file.isProject ? file.path : QString();
  openedName_ = QFileInfo(file.path).fileName();
  placementRemarks_.clear();
  lastPlacementSeconds_ = 0.0;
  parameterization_.reset();
  ready_ = std::move(file.ready);
  refreshDeformation(false);
  lastMovedVertices_ = 0;
  lastMilliseconds_ = 0.0;
  selection_->reset(static_cast<int>(committed_.controls.levels.size()));
  Q_EMIT opened();
  Q_EMIT titleChanged();
  Q_EMIT informed(openedMessage(openedName_, *committed_.mesh));
  for (const std::string& remark : committed_.mesh->mesh().remarks) {
    Q_EMIT informed(QString::fromStdString(remark));
  }
  for (const std::string& remark : file.remarks) {
    Q_EMIT remarked(QString::fromStdString(remark));
  }
}

void Document::performInBackground(const Edit& edit, const EditOptions& options) {
  const bool isPlacement = std::holds_alternative<Place>(edit.value());
  const auto work = [this, edit, options, isPlacement, base = committed_, revision = revision_,
                     workspace = workspace_](const Progress& progress) -> JobRunner::Deliver {
    QElapsedTimer timer;
    timer.start();
    const auto result = std::make_shared<const EditResult>(apply(base, edit, *workspace, progress));
    const double seconds = 1e-9 * static_cast<double>(timer.nsecsElapsed());
    const auto ready =
        std::make_shared<ReadyDeformation>(readyDeformation(result->project, *workspace, progress));
    return [this, edit, options, isPlacement, revision, result, seconds, ready] {
      if (revision != revision_) {
        Q_EMIT remarked(
            tr("The result was dropped, because the project changed in the meantime. Do it again."));
        return;
      }
      // The first placement came with the mesh: closing right after it loses nothing.
      const bool isFirst = isPlacement && history_->count() == 0 && committed_.controls.finest().empty();
      if (isPlacement) {
        lastPlacementSeconds_ = seconds;
      }
      ready_ = std::move(*ready);
      push(edit, *result, options);
      if (isFirst) {
        history_->setClean();
      }
      if (isPlacement) {
        Q_EMIT placed();
      }
    };
  };
  const QString title = isPlacement ? tr("Placing points") : tr("Working");
  jobs_->start({isPlacement ? "place" : "edit", title, work});
}

bool Document::save(const QString& path, const ProjectExtras& extras) {
  try {
    saveProject(pathOf(path), committed_, extras);
  } catch (const Error& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    return false;
  }
  path_ = path;
  extras_ = extras;
  history_->setClean();
  Q_EMIT titleChanged();
  Q_EMIT informed(tr("Saved %1.").arg(QFileInfo(path).fileName()));
  return true;
}

void Document::exportMesh(const QString& path) {
  const auto work = [this, path, project = committed_,
                     workspace = workspace_](const Progress& progress) -> JobRunner::Deliver {
    const MeshFormat format = formatOfEnding(pathOf(path));
    if (format == MeshFormat::none) {
      throw InvalidInput(
          tr("Could not export to %1: its ending names no mesh format. Use .obj, .off, .ply or .stl.")
              .arg(QFileInfo(path).fileName())
              .toStdString());
    }
    progress.report("Deforming");
    const DeformedShape shape = deformedShape(project, workspace->weights, progress);
    progress.report("Writing");
    const std::string bytes = encodeMesh(project.mesh->mesh(), shape, format, progress);
    progress.throwIfCancelled();
    writeFileAtomically(pathOf(path), bytes);
    return [this, path, losses = exportLosses(project.mesh->mesh(), format)] {
      Q_EMIT informed(tr("Exported %1.").arg(QFileInfo(path).fileName()));
      for (const std::string& loss : losses) {
        Q_EMIT remarked(QString::fromStdString(loss));
      }
    };
  };
  jobs_->start({"export", tr("Exporting %1").arg(QFileInfo(path).fileName()), work});
}

}  // namespace pbffd::ui
