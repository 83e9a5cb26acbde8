#pragma once

#include <QWidget>

class QLabel;

namespace pbffd::ui {

class Document;
class PageHeader;
class Theme;

/// The inspector's page of the mesh: counts, size, how it hangs together.
class MeshPage : public QWidget {
  Q_OBJECT

 public:
  MeshPage(Document& document, const Theme& theme, QWidget* parent = nullptr);
  void refresh();

 private:
  QLabel* addRow(class QVBoxLayout* column, const QString& name);

  Document& document_;
  PageHeader* header_;
  QLabel* vertices_;
  QLabel* triangles_;
  QLabel* faces_;
  QLabel* parts_;
  QLabel* surface_;
  QLabel* nonmanifold_;
  QLabel* isolated_;
  QLabel* size_;
  QLabel* low_;
  QLabel* high_;
  const void* shown_ = nullptr;  ///< the mesh that the labels tell of
};

}  // namespace pbffd::ui
