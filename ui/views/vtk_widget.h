#pragma once

#include <QOpenGLWidget>

#include <vtkNew.h>

class vtkCallbackCommand;
class vtkGenericOpenGLRenderWindow;
class vtkObject;

namespace pbffd::ui {

/// A Qt widget that shows a VTK render window: VTK draws into framebuffers of its own within the widget's
/// OpenGL context, and the finished frame is copied to the widget's. Drawn only when Qt asks for a paint,
/// that is at most once per turn of the event loop: call update() after a change.
class VtkWidget : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit VtkWidget(QWidget* parent = nullptr);
  ~VtkWidget() override;

  vtkGenericOpenGLRenderWindow* renderWindow() const { return window_; }
  /// From this frame on, or not: a measured frame is waited for.
  void setMeasured(bool isMeasured) { isMeasured_ = isMeasured; }

 Q_SIGNALS:
  /// Right before a frame: the time to bring the scene up to date.
  void aboutToRender();
  /// After a measured one; `seconds`: from aboutToRender() until the graphics card was done with it.
  void measured(double seconds);
  /// After every one.
  void rendered();

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  static void onWindowEvent(vtkObject* caller, unsigned long event, void* client, void* call);
  void releaseContext();
  void copyFrame();

  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkCallbackCommand> observer_;
  QMetaObject::Connection contextConnection_;
  bool isMeasured_ = false;
  bool isResizing_ = false;
};

}  // namespace pbffd::ui
