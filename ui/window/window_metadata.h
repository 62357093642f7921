#pragma once

#include "core/io/document_metadata.h"

namespace ui
{
class MainWindow;

// Parts of the window belong to the document, and come back with its file: from where it is looked at, the brush in
// the hand with its symmetry, and the reference images. Thread: gui.

void addMetadata(const MainWindow& window, core::DocumentMetadata& metadata);
/// Applies the notes of a model that the window shows already. View and brush stay as they are where they are not
/// noted.
void applyMetadata(MainWindow& window, const core::DocumentMetadata& metadata);
} // namespace ui
