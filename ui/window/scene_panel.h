#pragma once

#include <QWidget>

class QLineEdit;

namespace pbffd::ui {

class Document;
class SceneModel;
class SceneTree;
class Theme;
class ViewState;

/// The scene dock's content: filter, tree and the legend of the kinds of points.
class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  ScenePanel(Document& document, ViewState& view, const Theme& theme, QWidget* parent = nullptr);

  SceneTree& tree() const { return *tree_; }
  /// Puts the cursor into the filter.
  void startFilter();

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  SceneModel* model_;
  QLineEdit* filter_;
  SceneTree* tree_;
};

}  // namespace pbffd::ui
