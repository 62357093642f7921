#include "app/lesson/lesson_handout.h"

#include "app/lesson/lesson_cards.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QImage>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>

#include <algorithm>

namespace app
{
namespace
{
constexpr int dotsPerInch = 300;
constexpr double mm = dotsPerInch / 25.4;                     ///< dots per mm
constexpr double margin = 18, pictureSide = 38, distance = 6; ///< mm
constexpr double textPoints = 13, titlePoints = 15, headPoints = 22;

/// Lays out blocks from top to bottom, page after page.
class HandoutPages
{
public:
    explicit HandoutPages(QPdfWriter* writer) : m_writer(writer), m_painter(writer)
    {
        m_painter.setRenderHint(QPainter::SmoothPixmapTransform);
    }

    /// Adds a picture (may be null) with text beside it. A block that fits on one page is not split.
    void add(const QImage& picture, const QString& html)
    {
        const double side = picture.isNull() ? 0 : pictureSide * mm, gap = picture.isNull() ? 0 : distance * mm;
        QTextDocument text;
        text.documentLayout()->setPaintDevice(m_writer);
        text.setDocumentMargin(0);
        text.setHtml(html);
        text.setTextWidth(m_writer->width() - side - gap);
        const double height = std::max(side, text.size().height()), page = m_writer->height();
        if (m_top + height > page && (height <= page || m_top > page / 2))
            beginPage();
        if (!picture.isNull()) {
            const QSizeF size = QSizeF(picture.size()).scaled(side, side, Qt::KeepAspectRatio);
            m_painter.drawImage(QRectF(QPointF(0, m_top), size), picture);
        }
        draw(text, side + gap, height);
        m_top += distance * mm;
    }

private:
    void beginPage()
    {
        m_writer->newPage();
        m_top = 0;
    }

    /// Draws the text line by line, over several pages if needed. On the last page it occupies the remainder of
    /// `height` (dots).
    void draw(const QTextDocument& text, double left, double height)
    {
        double before = 0; // part of the height drawn on earlier pages, dots
        for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
            const QTextLayout& layout = *block.layout();
            for (int i = 0; i < layout.lineCount(); ++i) {
                const QTextLine line = layout.lineAt(i);
                const double top = layout.position().y() + line.y();
                if (m_top + top + line.height() - before > m_writer->height()) {
                    beginPage();
                    before = top;
                }
                line.draw(&m_painter, layout.position() + QPointF(left, m_top - before));
            }
        }
        m_top += height - before;
    }

    QPdfWriter* m_writer;
    QPainter m_painter;
    double m_top = 0; ///< top of the next block, dots
};

QString paragraph(const QString& text, double points, bool isBold)
{
    return QStringLiteral("<p style=\"font-size:%1pt; font-weight:%2; margin-top:0; margin-bottom:4pt\">%3</p>")
        .arg(points)
        .arg(isBold ? QStringLiteral("bold") : QStringLiteral("normal"),
             text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
}
} // namespace

QByteArray lessonHandout(const core::Lesson& lesson, const QString& language)
{
    const auto in = [&language](const core::LessonText& text) {
        return QString::fromStdString(text.in(language.toStdString()));
    };
    QBuffer file;
    file.open(QIODevice::WriteOnly);
    QPdfWriter writer(&file);
    const bool isLetter = QLocale().measurementSystem() == QLocale::ImperialUSSystem;
    writer.setPageLayout(QPageLayout(QPageSize(isLetter ? QPageSize::Letter : QPageSize::A4), QPageLayout::Portrait,
                                     {margin, margin, margin, margin}, QPageLayout::Millimeter));
    writer.setResolution(dotsPerInch);
    writer.setTitle(in(lesson.title));
    writer.setCreator(QStringLiteral("Fettle"));
    {
        HandoutPages pages(&writer);
        pages.add({}, paragraph(in(lesson.title), headPoints, true) + paragraph(in(lesson.summary), textPoints, false));
        int number = 0;
        for (const core::LessonStep& step : lesson.steps)
            pages.add(pictureOf(lesson, step.picture),
                      paragraph(QStringLiteral("%1. %2").arg(++number).arg(in(step.title)), titlePoints, true) +
                          paragraph(in(step.text), textPoints, false));
    }
    return file.data();
}
} // namespace app
