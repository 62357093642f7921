#pragma once

#include "core/io/document_metadata.h"

namespace ui
{
class MainWindow;

// What of the window belongs to the document, and comes back with its file: from where it is looked at, and the brush
// in the hand with its symmetry. Thread: gui.

void addMetadata(const MainWindow& window, core::DocumentMetadata& metadata);
/// Of a model that the window shows already. What is not noted stays as it is.
void applyMetadata(MainWindow& window, const core::DocumentMetadata& metadata);
} // namespace ui
