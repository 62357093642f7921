#pragma once

#include "ui/drawing/drawing_sheet.h"

#include "core/util/atomic_file.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

namespace ui
{
/// A PDF with sheets of several models, one on each page, painted as by writeSheet(). The file appears under its path
/// at commit(); without commit() nothing remains. Precondition: a QGuiApplication exists, because fonts are used.
/// Throws core::FileError from constructor and commit(). Thread: one at a time.
class SheetBook
{
public:
    SheetBook(const std::filesystem::path& path, const QString& title);

    void add(const DrawingSheet& sheet);
    bool isEmpty() const { return !m_painter.isActive(); }
    /// Writes the file. Precondition: at least one page was added.
    void commit();

private:
    core::AtomicFile m_file; ///< first member: an unwritable path fails before any painting
    QBuffer m_bytes;
    QPdfWriter m_writer{&m_bytes};
    QPainter m_painter; ///< last member: destroyed before its device; active from the first page on
};
} // namespace ui
