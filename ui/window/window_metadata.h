#pragma once

#include "core/io/document_metadata.h"

namespace ui
{
class MainWindow;

// Copies the window's part of the document into its metadata: the view, the brush with its symmetry, and the reference
// images. Thread: gui.

void addMetadata(const MainWindow& window, core::DocumentMetadata& metadata);
/// Applies metadata to the window, which must already show the model. View and brush are unchanged if the metadata does
/// not contain them.
void applyMetadata(MainWindow& window, const core::DocumentMetadata& metadata);
} // namespace ui
