#include "ui/window/mesh_page.h"

#include "ui/document/document.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"
#include "ui/window/number_field.h"
#include "ui/window/page_header.h"
#include "ui/window/section.h"

#include <QVBoxLayout>

#include <map>

namespace pbffd::ui {
namespace {

QString triple(const Vec3& values) {
  QStringList words;
  for (int axis = 0; axis < 3; ++axis) {
    words += QString::number(values[axis], 'g', 5).replace(u'-', QChar(0x2212));
  }
  return words.join("  ");
}

/// "2,903 quads, 12 triangles": the faces by their number of corners.
QString facesBySize(const Polygons& faces) {
  std::map<std::size_t, Index> counts;
  for (Index face = 0; face < faces.size(); ++face) {
    ++counts[faces[face].size()];
  }
  QStringList words;
  for (const auto& [size, count] : counts) {
    const QString name = size == 3   ? QObject::tr("triangles")
                         : size == 4 ? QObject::tr("quads")
                                     : QObject::tr("with %1 corners").arg(size);
    words += counted(count) + " " + name;
    if (words.size() == 3) {
      break;
    }
  }
  return counts.size() > 3 ? counted(faces.size()) : words.join(", ");
}

}  // namespace

MeshPage::MeshPage(Document& document, const Theme& theme, QWidget* parent)
    : QWidget(parent), document_(document), header_(new PageHeader(theme)) {
  auto* counts = new Section(theme, tr("Mesh"));
  vertices_ = addRow(counts->body(), tr("Vertices"));
  triangles_ = addRow(counts->body(), tr("Triangles"));
  faces_ = addRow(counts->body(), tr("Faces"));
  parts_ = addRow(counts->body(), tr("Parts"));
  auto* topology = new Section(theme, tr("Surface"));
  surface_ = addRow(topology->body(), tr("Closed"));
  nonmanifold_ = addRow(topology->body(), tr("Edges of more than two faces"));
  isolated_ = addRow(topology->body(), tr("Vertices of no face"));
  auto* bounds = new Section(theme, tr("Bounds"));
  size_ = addRow(bounds->body(), tr("Size"));
  low_ = addRow(bounds->body(), tr("From"));
  high_ = addRow(bounds->body(), tr("To"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(counts);
  column->addWidget(topology);
  column->addWidget(bounds);
  column->addStretch();
}

QLabel* MeshPage::addRow(QVBoxLayout* column, const QString& name) {
  auto* row = new QHBoxLayout;
  QLabel* value = makeLabel({}, "value");
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setAccessibleName(name);
  row->addWidget(makeLabel(name, "label"));
  row->addStretch();
  row->addWidget(value);
  column->addLayout(row);
  return value;
}

void MeshPage::refresh() {
  const RestMesh* mesh = document_.shown().mesh.get();
  if (mesh == nullptr || shown_ == mesh) {
    return;
  }
  shown_ = mesh;
  const Topology& topology = mesh->topology();
  header_->show({"mesh", "accent", "accent.bg", document_.meshName(), tr("Nothing selected: the mesh")});
  vertices_->setText(counted(mesh->vertexCount()));
  triangles_->setText(counted(mesh->triangles().size()));
  faces_->setText(facesBySize(mesh->mesh().faces));
  parts_->setText(counted(topology.components));
  surface_->setText(topology.isClosed ? tr("yes")
                                      : tr("no, %1 border edges").arg(counted(topology.boundaryEdges)));
  nonmanifold_->setText(topology.nonmanifoldEdges == 0 ? tr("none") : counted(topology.nonmanifoldEdges));
  isolated_->setText(topology.isolatedVertices == 0 ? tr("none") : counted(topology.isolatedVertices));
  const Bounds& bounds = mesh->bounds();
  size_->setText(triple(bounds.high - bounds.low));
  low_->setText(triple(bounds.low));
  high_->setText(triple(bounds.high));
}

}  // namespace pbffd::ui
