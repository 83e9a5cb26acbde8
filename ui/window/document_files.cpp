#include "ui/window/document_files.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/edit_json.h"
#include "ui/controllers/actions.h"
#include "ui/document/change_project.h"
#include "ui/document/document.h"
#include "ui/document/theme.h"
#include "ui/document/view_state.h"
#include "ui/models/history_model.h"
#include "ui/window/recent_files.h"
#include "ui/window/thumbnail.h"

#include <QBuffer>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPainter>
#include <QPushButton>

namespace pbffd::ui {
namespace {

constexpr int thumbnailSize = 256;
const QSize recentSize(148, 84);

std::filesystem::path pathOf(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

QString meshFilter() {
  return DocumentFiles::tr("Meshes (*.obj *.ply *.stl *.off);;All files (*)");
}

QString projectFilter() {
  return DocumentFiles::tr("Projects (*.pbffd);;All files (*)");
}

/// The deformed vertices in file order, as the screen has them.
Points positionsOf(const LiveDeformation& deformation, const RestMesh& mesh) {
  Points positions(mesh.vertexCount(), 3);
  const auto& order = mesh.mortonOrder();
  const auto& slots_ = deformation.positions();
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    for (int axis = 0; axis < 3; ++axis) {
      positions(order[slot], axis) = slots_[3 * slot + static_cast<std::size_t>(axis)];
    }
  }
  return positions;
}

}  // namespace

DocumentFiles::DocumentFiles(const Sources& sources, const Actions& actions, QWidget& window)
    : QObject(&window),
      sources_(sources),
      document_(sources.document),
      window_(window),
      folder_(QDir::homePath()) {
  connectActions(actions);
  connect(&document_, &Document::placed, this, &DocumentFiles::remember);
  connect(&document_, &Document::opened, this, [this] {
    if (!document_.path().isEmpty()) {
      remember();
    }
  });
}

void DocumentFiles::connectActions(const Actions& actions) {
  const auto on = [&](ActionId id, auto&& does) { connect(actions[id], &QAction::triggered, this, does); };
  on(ActionId::openMesh, [this] { chooseMesh(); });
  on(ActionId::openProject, [this] { chooseProject(); });
  on(ActionId::save, [this] { save(); });
  on(ActionId::saveAs, [this] { saveAs(); });
  on(ActionId::exportMesh, [this] { exportMesh(); });
  on(ActionId::exportPicture, [this] { exportPicture(); });
  on(ActionId::runEdits, [this] { runEdits(); });
  on(ActionId::saveEdits, [this] { saveEdits(); });
  on(ActionId::closeDocument, [this] {
    if (mayLeave()) {
      document_.close();
    }
  });
}

QString DocumentFiles::reasonAgainst(const QStringList& paths) {
  if (paths.size() != 1) {
    return tr("One file at a time, please.");
  }
  const QFileInfo file(paths.front());
  if (!file.isFile()) {
    return tr("%1 is not a file.").arg(file.fileName());
  }
  const bool isKnown = file.suffix().compare("pbffd", Qt::CaseInsensitive) == 0 ||
                       formatOfEnding(pathOf(paths.front())) != MeshFormat::none;
  return isKnown ? QString()
                 : tr("%1 is of no kind that opens here: OBJ, PLY, STL, OFF or PBFFD.").arg(file.fileName());
}

void DocumentFiles::open(const QString& path) {
  if (mayLeave()) {
    openedPath_ = QFileInfo(path).absoluteFilePath();
    folder_ = QFileInfo(path).absolutePath();
    document_.open(openedPath_);
  }
}

void DocumentFiles::chooseMesh() {
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Open mesh"), folder_, meshFilter());
  if (!path.isEmpty()) {
    open(path);
  }
}

void DocumentFiles::chooseProject() {
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Open project"), folder_, projectFilter());
  if (!path.isEmpty()) {
    open(path);
  }
}

QImage DocumentFiles::thumbnail(const QSize& size) const {
  const RestMesh& mesh = *document_.shown().mesh;
  return renderThumbnail(positionsOf(*document_.deformation(), mesh), mesh.triangles(), size);
}

bool DocumentFiles::save() {
  return document_.path().isEmpty() ? saveAs() : saveTo(document_.path());
}

bool DocumentFiles::saveTo(const QString& path) {
  QImage picture(thumbnailSize, thumbnailSize, QImage::Format_ARGB32);
  picture.fill(sources_.theme.color("panel"));
  QPainter painter(&picture);
  painter.drawImage(0, 0, thumbnail(picture.size()));
  painter.end();
  QByteArray png;
  QBuffer buffer(&png);
  picture.save(&buffer, "PNG");
  if (!document_.save(path, {png.toStdString(), sources_.view.toJson().toStdString()})) {
    return false;
  }
  remember();
  return true;
}

QString DocumentFiles::suggestedPath(const QString& ending) const {
  const QString present = document_.path().isEmpty() ? folder_ + "/" + document_.meshName() : document_.path();
  const QFileInfo file(present);
  return file.absolutePath() + "/" + file.completeBaseName() + ending;
}

bool DocumentFiles::saveAs() {
  QFileDialog dialog(&window_, tr("Save project"), folder_, projectFilter());
  dialog.setObjectName("saveDialog");
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix("pbffd");
  dialog.selectFile(suggestedPath(".pbffd"));
  if (dialog.exec() != QDialog::Accepted) {
    return false;
  }
  return saveTo(dialog.selectedFiles().front());
}

void DocumentFiles::exportMesh() {
  const QString ending = "." + QFileInfo(document_.meshName()).suffix();
  QFileDialog dialog(&window_, tr("Export the deformed mesh"), folder_,
                     tr("OBJ (*.obj);;PLY (*.ply);;STL (*.stl);;OFF (*.off)"));
  dialog.setObjectName("exportDialog");
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  for (const QString& filter : dialog.nameFilters()) {
    if (filter.contains("*" + ending.toLower())) {
      dialog.selectNameFilter(filter);
    }
  }
  dialog.setDefaultSuffix(ending.mid(1));
  connect(&dialog, &QFileDialog::filterSelected, &dialog,
          [&dialog](const QString& filter) { dialog.setDefaultSuffix(filter.left(3).toLower()); });
  dialog.selectFile(suggestedPath("-deformed" + ending));
  if (dialog.exec() == QDialog::Accepted) {
    document_.exportMesh(dialog.selectedFiles().front());
  }
}

void DocumentFiles::exportPicture() {
  const QString path =
      QFileDialog::getSaveFileName(&window_, tr("Export picture"), suggestedPath(".png"), tr("PNG (*.png)"));
  if (!path.isEmpty()) {
    Q_EMIT pictureAsked(path);
  }
}

void DocumentFiles::runEdits() {
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Run edits from file"), folder_,
                                                    tr("Edits (*.json);;All files (*)"));
  if (path.isEmpty()) {
    return;
  }
  try {
    const QString name = QFileInfo(path).fileName();
    Group run{tr("Run %1").arg(name).toStdString(), parseEdits(readFile(pathOf(path)), name.toStdString())};
    if (!run.edits.empty()) {
      document_.performInBackground(run);
    }
  } catch (const Error& error) {
    Q_EMIT document_.failed(QString::fromUtf8(error.what()));
  }
}

void DocumentFiles::saveEdits() {
  const QString path = QFileDialog::getSaveFileName(&window_, tr("Save the steps so far as edits"),
                                                    suggestedPath(".json"), tr("Edits (*.json)"));
  if (path.isEmpty()) {
    return;
  }
  try {
    writeFileAtomically(pathOf(path), HistoryModel(document_).editsJson().toStdString());
    Q_EMIT document_.informed(tr("Saved the steps to %1.").arg(QFileInfo(path).fileName()));
  } catch (const Error& error) {
    Q_EMIT document_.failed(QString::fromUtf8(error.what()));
  }
}

bool DocumentFiles::mayLeave() {
  if (!document_.isOpen() || !document_.isModified()) {
    return true;
  }
  QMessageBox question(&window_);
  question.setObjectName("saveQuestion");
  question.setWindowTitle(tr("Save changes?"));
  question.setText(tr("Save the changes to %1?").arg(document_.displayName()));
  question.setInformativeText(tr("Otherwise they are lost."));
  question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  question.setDefaultButton(QMessageBox::Save);
  switch (question.exec()) {
    case QMessageBox::Save:
      return save();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

/// Puts what is open on the list of recent files: the project, or the mesh that was never saved.
void DocumentFiles::remember() {
  const QString path = document_.path().isEmpty() ? openedPath_ : document_.path();
  if (path.isEmpty() || !sources_.recent.isKept() || document_.deformation() == nullptr) {
    return;
  }
  sources_.recent.keepPicture(path, thumbnail(recentSize));
  sources_.recent.add(path, document_.committed().controls.finest().size());
}

}  // namespace pbffd::ui
