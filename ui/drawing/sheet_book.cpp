#include "ui/drawing/sheet_book.h"

namespace ui
{
SheetBook::SheetBook(const std::filesystem::path& path, const QString& title) : m_file(path)
{
    m_bytes.open(QIODevice::WriteOnly);
    prepareForSheets(m_writer, title);
}

void SheetBook::add(const DrawingSheet& sheet)
{
    if (m_painter.isActive()) {
        m_writer.newPage();
    } else {
        m_painter.begin(&m_writer);
        scaleToSheet(m_painter);
    }
    paintSheet(m_painter, sheet);
}

void SheetBook::commit()
{
    Q_ASSERT(m_painter.isActive());
    m_painter.end();
    m_file.write({m_bytes.data().constData(), static_cast<std::size_t>(m_bytes.data().size())});
    m_file.commit();
}
} // namespace ui
