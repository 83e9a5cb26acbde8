#include "ui/views/vtk_widget.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScopedValueRollback>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

namespace pbffd::ui {

VtkWidget::VtkWidget(QWidget* parent) : QOpenGLWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);

  window_->SetReadyForRendering(false);
  window_->SetFrameBlitModeToNoBlit();
  window_->SetMultiSamples(0);
  window_->SwapBuffersOn();
  observer_->SetCallback(&VtkWidget::onWindowEvent);
  observer_->SetClientData(this);
  window_->AddObserver(vtkCommand::WindowMakeCurrentEvent, observer_);
  window_->AddObserver(vtkCommand::WindowIsCurrentEvent, observer_);
}

VtkWidget::~VtkWidget() {
  // First of all: the context's own destruction must not find a half-destroyed widget.
  QObject::disconnect(contextConnection_);
  releaseContext();
  window_->RemoveObserver(observer_);
}

void VtkWidget::releaseContext() {
  if (context() == nullptr || !window_->GetReadyForRendering()) {
    return;
  }
  makeCurrent();
  window_->Finalize();
  window_->SetReadyForRendering(false);
  doneCurrent();
}

void VtkWidget::initializeGL() {
  QObject::disconnect(contextConnection_);
  contextConnection_ =
      connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkWidget::releaseContext);
  window_->GetState()->Reset();
  window_->GetState()->vtkglDepthFunc(GL_LEQUAL);
  window_->SetOwnContext(0);
  window_->SetReadyForRendering(true);
  window_->OpenGLInitContext();
}

void VtkWidget::resizeGL(int width, int height) {
  const double ratio = devicePixelRatioF();
  window_->SetSize(qRound(width * ratio), qRound(height * ratio));
  window_->SetDPI(qRound(72 * ratio));
}

/// Qt would paint within each of the resizes that a change of layout comes in; one frame after them all is
/// enough.
void VtkWidget::resizeEvent(QResizeEvent* event) {
  const QScopedValueRollback guard(isResizing_, true);
  QOpenGLWidget::resizeEvent(event);
  update();
}

void VtkWidget::paintGL() {
  if (!window_->GetReadyForRendering() || isResizing_) {
    return;
  }
  QElapsedTimer timer;
  timer.start();
  resizeGL(width(), height());  // a move to another screen changes the ratio without a resize
  Q_EMIT aboutToRender();
  window_->GetState()->Reset();
  window_->GetState()->Push();
  window_->GetState()->vtkglDepthFunc(GL_LEQUAL);
  window_->Render();
  makeCurrent();
  copyFrame();
  window_->GetState()->Pop();
  context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  if (isMeasured_) {
    // Else the time would only be that of handing the work over.
    context()->functions()->glFinish();
    Q_EMIT measured(1e-9 * static_cast<double>(timer.nsecsElapsed()));
  }
  Q_EMIT rendered();
}

void VtkWidget::copyFrame() {
  QOpenGLFunctions* gl = context()->functions();
  vtkOpenGLState* state = window_->GetState();
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  state->vtkglDisable(GL_SCISSOR_TEST);
  window_->BlitDisplayFramebuffer();
  // VTK leaves shares of the last translucent layer in the alpha channel, which Qt would blend with.
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void VtkWidget::onWindowEvent(vtkObject*, unsigned long event, void* client, void* call) {
  auto* self = static_cast<VtkWidget*>(client);
  if (self->context() == nullptr) {
    return;
  }
  const bool isCurrent = QOpenGLContext::currentContext() == self->context();
  if (event == vtkCommand::WindowIsCurrentEvent) {
    *static_cast<bool*>(call) = isCurrent;
  } else if (event == vtkCommand::WindowMakeCurrentEvent && !isCurrent) {
    // Not when it is current: makeCurrent() binds Qt's framebuffer behind the state that VTK remembers.
    self->makeCurrent();
  }
}

}  // namespace pbffd::ui
