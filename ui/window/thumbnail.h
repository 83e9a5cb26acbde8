#pragma once

#include "core/mesh/mesh.h"

#include <QImage>

namespace pbffd::ui {

/// A small picture of a mesh from the front right above, shaded, on nothing: for start page cards, recent
/// files and project files. Drawn by the processor, so it needs no window and may run on any thread.
QImage renderThumbnail(const Points& positions, const Triangles& triangles, const QSize& size);

}  // namespace pbffd::ui
