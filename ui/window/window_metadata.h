#pragma once

#include "core/io/document_metadata.h"

namespace ui
{
class MainWindow;

// Parts of the window belong to the document, and come back with its file: from where it is looked at, the brush in
// the hand with its symmetry, and the reference images. Thread: gui.

void addMetadata(const MainWindow& window, core::DocumentMetadata& metadata);
/// Applies the metadata of a model that the window shows already. View and brush stay as they are if the metadata does
/// not contain them.
void applyMetadata(MainWindow& window, const core::DocumentMetadata& metadata);
} // namespace ui
