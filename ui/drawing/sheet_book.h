#pragma once

#include "ui/drawing/drawing_sheet.h"

#include "core/util/atomic_file.h"

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

namespace ui
{
/// Sheets of several models in one PDF, a page each, as writeSheet() makes one. Nothing is seen under the path before
/// commit(), and nothing remains without it. Needs a QGuiApplication, whose fonts it uses. One thread. Constructor and
/// commit() throw core::FileError.
class SheetBook
{
public:
    SheetBook(const std::filesystem::path& path, const QString& title);

    void add(const DrawingSheet& sheet);
    bool isEmpty() const { return !m_painter.isActive(); }
    /// With one page at least.
    void commit();

private:
    core::AtomicFile m_file; ///< what cannot be written is not painted
    QBuffer m_bytes;
    QPdfWriter m_writer{&m_bytes};
    QPainter m_painter; ///< last: it ends before its device; active from the first page on
};
} // namespace ui
