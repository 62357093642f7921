#pragma once

#include "core/io/document_metadata.h"

namespace ui
{
class MainWindow;

// What of the window belongs to the document, and comes back with its file: from where it is looked at, the brush in
// the hand with its symmetry, and the reference images. Thread: gui.

void addMetadata(const MainWindow& window, core::DocumentMetadata& metadata);
/// Of a model that the window shows already. View and brush stay as they are where they are not noted.
void applyMetadata(MainWindow& window, const core::DocumentMetadata& metadata);
} // namespace ui
