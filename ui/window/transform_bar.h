#pragma once

#include <QWidget>

class QAction;

namespace pbffd::ui {

class Theme;
class TransformOptions;

/// The options of the tools that move, rotate and scale: axes, pivot, snap.
class TransformBar : public QWidget {
  Q_OBJECT

 public:
  TransformBar(TransformOptions& options, QAction& snap, QWidget* parent = nullptr);
};

}  // namespace pbffd::ui
