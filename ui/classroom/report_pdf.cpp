// Steps: lay out each row, distribute the rows to pages, paint page by page. Layout is in units of 1/100 mm: font sizes
// are whole numbers of units, so small units allow nearly any size.
#include "ui/classroom/report_pdf.h"

#include "ui/classroom/class_report.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QTextLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

namespace ui
{
namespace
{
struct PageText
{
    Q_DECLARE_TR_FUNCTIONS(ui::ClassReport)
};

constexpr int unitsPerMm = 100, reportDotsPerInch = 1200; ///< units of the painter in a mm; resolution of the file
constexpr double mmPerInch = 25.4;
constexpr QSizeF paperSize{210, 297};
constexpr double pageMargin = 12, gapAcross = 2.5, gapDown = 1.6, pictureSide = 18;       ///< mm
constexpr double titleHeight = 5.5, headHeight = 2.7, cellHeight = 2.8, noteHeight = 2.5; ///< mm; heights of letters
constexpr double titleSpace = 17, headerSpace = 6, footerSpace = 7;                       ///< mm

const QColor inkColor(Qt::black), faintColor(90, 90, 96), ruleColor(190, 190, 196);
/// Colours of the HTML page (report_html.cpp).
const QColor readyColor(0x1e, 0x7a, 0x3a), notReadyColor(0xb3, 0x26, 0x1e), linkColor(0x0b, 0x57, 0xb8);

/// A column to the right of the picture, in the order of reportHeads().
struct ReportColumn
{
    double width; ///< mm
    Qt::Alignment side;
};
constexpr std::array reportColumns{ReportColumn{38, Qt::AlignLeft},  ReportColumn{37, Qt::AlignRight},
                                   ReportColumn{20, Qt::AlignRight}, ReportColumn{39, Qt::AlignLeft},
                                   ReportColumn{19, Qt::AlignRight}, ReportColumn{15, Qt::AlignRight}};
constexpr double contentWidth(const ReportColumn& column)
{
    return column.width - gapAcross;
}

struct TextStyle
{
    double height; ///< mm
    QColor color;
    bool isBold = false;
    Qt::Alignment side = Qt::AlignLeft;
};

QFont fontOf(const TextStyle& style)
{
    QFont font;
    font.setPixelSize(static_cast<int>(style.height * unitsPerMm));
    font.setBold(style.isBold);
    return font;
}

/// A text wrapped to a given width.
class TextBlock
{
public:
    /// `link`: target of a click on the text; empty: none. `width`: mm.
    TextBlock(const QString& text, const TextStyle& style, double width, const QString& link = {})
        : m_layout(text, fontOf(style))
        , m_color(style.color)
    {
        QTextOption option(style.side);
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        m_layout.setTextOption(option);
        if (!link.isEmpty()) {
            QTextCharFormat format;
            format.setAnchor(true);
            format.setAnchorHref(link);
            m_layout.setFormats({{0, static_cast<int>(text.size()), format}});
        }
        m_layout.beginLayout();
        for (QTextLine line = m_layout.createLine(); line.isValid(); line = m_layout.createLine()) {
            line.setLineWidth(width * unitsPerMm);
            line.setPosition({0, m_height});
            m_height += line.height();
        }
        m_layout.endLayout();
    }

    double height() const { return m_height / unitsPerMm; } ///< mm
    void paint(QPainter& painter, const QPointF& at) const
    {
        painter.setPen(m_color);
        m_layout.draw(&painter, at * unitsPerMm);
    }

private:
    QTextLayout m_layout;
    QColor m_color;
    double m_height = 0; ///< height in painter units (1/100 mm)
};

/// Text blocks of one cell, from top to bottom.
using TextCell = std::vector<std::unique_ptr<TextBlock>>;

double heightOf(const TextCell& cell)
{
    double height = 0;
    for (const auto& block : cell)
        height += block->height();
    return height;
}

void paintCell(QPainter& painter, const TextCell& cell, QPointF at)
{
    for (const auto& block : cell) {
        block->paint(painter, at);
        at.ry() += block->height();
    }
}

struct RowLayout
{
    const QImage* picture;
    std::array<TextCell, reportColumns.size()> cells;
    double height; ///< mm
};

RowLayout layoutOf(const ReportRow& row, const std::filesystem::path& path)
{
    const ReportCells words = cellsOf(row);
    RowLayout layout{&row.picture, {}, row.picture.isNull() ? 0 : pictureSide};
    const auto add = [&layout](std::size_t column, const QString& text, TextStyle style, const QString& link = {}) {
        style.side = reportColumns[column].side;
        if (!text.isEmpty())
            layout.cells[column].push_back(
                std::make_unique<TextBlock>(text, style, contentWidth(reportColumns[column]), link));
    };
    add(0, words.name, {cellHeight, linkColor, true}, reportLink(path, row.file));
    add(0, words.lesson, {noteHeight, faintColor});
    add(1, words.size, {cellHeight, inkColor});
    add(2, words.volume, {cellHeight, inkColor});
    add(3, words.word, {cellHeight, words.verdict == ReportVerdict::Ready ? readyColor : notReadyColor, true});
    add(3, words.note, {noteHeight, faintColor});
    add(4, words.time, {cellHeight, inkColor});
    add(5, words.strokes, {cellHeight, inkColor});
    for (const TextCell& cell : layout.cells)
        layout.height = std::max(layout.height, heightOf(cell));
    layout.height += 2 * gapDown;
    return layout;
}

constexpr double tableWidth = paperSize.width() - 2 * pageMargin;    ///< mm
constexpr double figureWidth = 15, pointWidth = 9;                   ///< smallest widths, mm
constexpr double questionsTitleHeight = 4, questionsTitleSpace = 16; ///< mm

/// The table of questions: a row of heads and a row for each question.
class QuestionTable
{
public:
    explicit QuestionTable(const ClassReport& report)
    {
        const QList<QuestionCells> questions = questionCellsOf(report);
        if (questions.isEmpty())
            return;
        const TextStyle headStyle{headHeight, faintColor, true};
        m_widths = widthsFor(questionHeads(), headStyle);
        addRow(questionHeads(), headStyle);
        for (const QuestionCells& question : questions) {
            QStringList texts{question.question, question.answers, question.mean};
            for (const QString& count : question.counts)
                texts << count;
            addRow(texts, {cellHeight, inkColor});
            m_rows.back().front().push_back(std::make_unique<TextBlock>(
                question.scale, TextStyle{noteHeight, faintColor}, m_widths.front() - gapAcross));
        }
    }

    /// Returns the height, mm; 0 if nobody answered.
    double height() const
    {
        double height = m_rows.empty() ? 0 : questionsTitleSpace;
        for (const QuestionRow& row : m_rows)
            height += rowHeight(row);
        return height;
    }

    void paint(QPainter& painter, double y) const;

private:
    using QuestionRow = std::vector<TextCell>;

    /// Returns the widths of the columns, mm. The columns for answers and mean are wide enough for their heads; the
    /// points have a fixed width; the question, which is first, gets the rest.
    static std::vector<double> widthsFor(const QStringList& heads, const TextStyle& style)
    {
        const QFontMetricsF metrics(fontOf(style));
        std::vector<double> widths(static_cast<std::size_t>(heads.size()), pointWidth);
        for (const std::size_t column : {1, 2}) {
            const double head = metrics.horizontalAdvance(heads[static_cast<qsizetype>(column)]) / unitsPerMm;
            widths[column] = std::max(figureWidth, std::ceil(head + gapAcross));
        }
        widths.front() = tableWidth - std::accumulate(widths.begin() + 1, widths.end(), 0.0);
        return widths;
    }
    static double rowHeight(const QuestionRow& row)
    {
        double height = 0;
        for (const TextCell& cell : row)
            height = std::max(height, heightOf(cell));
        return height + 2 * gapDown;
    }

    void addRow(const QStringList& texts, TextStyle style)
    {
        QuestionRow& row = m_rows.emplace_back();
        for (const QString& text : texts) {
            style.side = row.empty() ? Qt::AlignLeft : Qt::AlignRight;
            const double width = m_widths[row.size()] - gapAcross;
            row.emplace_back().push_back(std::make_unique<TextBlock>(text, style, width));
        }
    }

    std::vector<double> m_widths; ///< mm
    std::vector<QuestionRow> m_rows;
};

/// Returns the height left for rows on the first page or on a later page, mm.
double availableHeight(bool isFirst)
{
    return paperSize.height() - 2 * pageMargin - headerSpace - footerSpace - (isFirst ? titleSpace : 0);
}

/// Returns the number of rows on each page. A row higher than a page gets its own page. The content after the rows,
/// `end` mm high, is on the last page, which may have no rows.
std::vector<std::size_t> paginated(std::span<const RowLayout> rows, double end)
{
    std::vector<std::size_t> pages{0};
    double left = availableHeight(true);
    for (const RowLayout& row : rows) {
        if (row.height > left && pages.back() > 0) {
            pages.push_back(0);
            left = availableHeight(false);
        }
        ++pages.back();
        left -= row.height;
    }
    if (end > left)
        pages.push_back(0);
    return pages;
}

void paintRule(QPainter& painter, double y)
{
    painter.setPen(QPen(ruleColor, 0.2 * unitsPerMm));
    painter.drawLine(QPointF(pageMargin, y) * unitsPerMm, QPointF(paperSize.width() - pageMargin, y) * unitsPerMm);
}

/// Paints one line; elides the text if it is too long.
void paintLine(QPainter& painter, const QString& text, const TextStyle& style, const QPointF& at)
{
    const double width = paperSize.width() - pageMargin - at.x();
    const QString elided = QFontMetricsF(fontOf(style)).elidedText(text, Qt::ElideMiddle, width * unitsPerMm);
    TextBlock(elided, style, width).paint(painter, at);
}

void paintTitle(QPainter& painter, const ClassReport& report)
{
    paintLine(painter, reportTitle(report), {titleHeight, inkColor, true}, {pageMargin, pageMargin});
    paintLine(painter, reportSummary(report), {cellHeight, faintColor}, {pageMargin, pageMargin + 1.6 * titleHeight});
}

void paintHeads(QPainter& painter, double y)
{
    const QStringList heads = reportHeads();
    double x = pageMargin + pictureSide;
    for (std::size_t i = 0; i < reportColumns.size(); ++i) {
        x += gapAcross / 2;
        TextBlock(heads[static_cast<qsizetype>(i)], {headHeight, faintColor, true, reportColumns[i].side},
                  contentWidth(reportColumns[i]))
            .paint(painter, {x, y});
        x += reportColumns[i].width - gapAcross / 2;
    }
    paintRule(painter, y + headerSpace - 1);
}

void paintRow(QPainter& painter, const RowLayout& row, double y)
{
    const double middle = y + row.height / 2;
    if (!row.picture->isNull())
        painter.drawImage(QRectF(QPointF(pageMargin, middle - pictureSide / 2) * unitsPerMm,
                                 QSizeF(pictureSide, pictureSide) * unitsPerMm),
                          *row.picture);
    double x = pageMargin + pictureSide;
    for (std::size_t i = 0; i < reportColumns.size(); ++i) {
        paintCell(painter, row.cells[i], {x + gapAcross / 2, middle - heightOf(row.cells[i]) / 2});
        x += reportColumns[i].width;
    }
    paintRule(painter, y + row.height);
}

void QuestionTable::paint(QPainter& painter, double y) const
{
    if (m_rows.empty())
        return;
    paintLine(painter, questionsTitle(), {questionsTitleHeight, inkColor, true},
              {pageMargin, y + questionsTitleSpace - 2 * questionsTitleHeight});
    y += questionsTitleSpace;
    for (const QuestionRow& row : m_rows) {
        double x = pageMargin;
        for (std::size_t i = 0; i < row.size(); ++i) {
            paintCell(painter, row[i], {x + gapAcross / 2, y + (rowHeight(row) - heightOf(row[i])) / 2});
            x += m_widths[i];
        }
        y += rowHeight(row);
        paintRule(painter, y);
    }
}

void paintFoot(QPainter& painter, const ClassReport& report, const QString& number)
{
    const double y = paperSize.height() - pageMargin - noteHeight;
    const double width = paperSize.width() - 2 * pageMargin;
    TextBlock(number, {noteHeight, faintColor, false, Qt::AlignRight}, width).paint(painter, {pageMargin, y});
    const double half = width / 2 * unitsPerMm;
    const TextStyle style{noteHeight, faintColor};
    TextBlock(QFontMetricsF(fontOf(style)).elidedText(reportTitle(report), Qt::ElideMiddle, half), style, width)
        .paint(painter, {pageMargin, y});
}
} // namespace

QByteArray reportPdf(const ClassReport& report, const std::filesystem::path& path)
{
    QBuffer file;
    file.open(QIODevice::WriteOnly);
    QPdfWriter writer(&file);
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, {}));
    writer.setResolution(reportDotsPerInch);
    writer.setTitle(reportTitle(report));
    writer.setCreator(QStringLiteral("Fettle"));
    QPainter painter(&writer);
    painter.scale(reportDotsPerInch / mmPerInch / unitsPerMm, reportDotsPerInch / mmPerInch / unitsPerMm);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);

    std::vector<RowLayout> rows;
    for (const ReportRow& row : report.rows)
        rows.push_back(layoutOf(row, path));
    const QuestionTable questions(report);
    const std::vector<std::size_t> pages = paginated(rows, questions.height());
    auto row = rows.cbegin();
    for (std::size_t page = 0; page < pages.size(); ++page) {
        if (page > 0)
            writer.newPage();
        else
            paintTitle(painter, report);
        double y = pageMargin + (page > 0 ? 0 : titleSpace);
        if (pages[page] > 0) {
            paintHeads(painter, y);
            y += headerSpace;
        }
        for (const auto end = row + static_cast<std::ptrdiff_t>(pages[page]); row != end; ++row) {
            paintRow(painter, *row, y);
            y += row->height;
        }
        if (page + 1 == pages.size())
            questions.paint(painter, y);
        paintFoot(painter, report, PageText::tr("Page %1 of %2").arg(page + 1).arg(pages.size()));
    }
    painter.end();
    return file.data();
}
} // namespace ui
