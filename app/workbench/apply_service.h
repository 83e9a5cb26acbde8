#pragma once

#include "ui/document/apply_service.h"

namespace pbffd::workbench {

/// applyToFile() for the window.
ui::ApplyService applyService();

}  // namespace pbffd::workbench
