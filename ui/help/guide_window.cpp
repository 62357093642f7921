#include "ui/help/guide_window.h"

#include "ui/actions/actions.h"
#include "ui/help/help_text.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr QSize defaultSize{1040, 700}; // fits the pictures, which are up to 700 pixels wide
constexpr QSize frameRoom{16, 48};      ///< pixels for the window manager's frame
constexpr int contentsWidth = 235;
enum Role { Id = Qt::UserRole, Text };

/// Formats a table: horizontal lines only, and removes the empty heading row that Markdown requires.
void layOut(QTextTable* table, const QColor& line)
{
    QTextTableFormat format = table->format();
    format.setBorderCollapse(true);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(line);
    format.setBorder(0.5);
    format.setCellSpacing(0);
    format.setCellPadding(gap / 2);
    format.setBottomMargin(gap);
    table->setFormat(format);
    table->removeRows(0, 1);
}

/// Formats a page: larger line spacing and space above the headings.
void layOut(QTextDocument* document, const QColor& line)
{
    for (QTextFrame* frame : document->rootFrame()->childFrames())
        if (auto* table = qobject_cast<QTextTable*>(frame))
            layOut(table, line);
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        QTextCursor cursor(block);
        QTextBlockFormat format = block.blockFormat();
        if (!block.text().contains(QChar::ObjectReplacementCharacter))
            format.setLineHeight(130, QTextBlockFormat::ProportionalHeight);
        format.setTopMargin(format.headingLevel() > 1 ? 2 * gap : format.topMargin());
        format.setBottomMargin(gap);
        cursor.setBlockFormat(format);
    }
}
} // namespace

GuideWindow::GuideWindow(const Actions& actions, QWidget* parent)
    : QDialog(parent)
    , m_actions(actions)
    , m_words(new QLineEdit)
    , m_contents(new QListWidget)
    , m_text(new QTextBrowser)
    , m_nothing(new QLabel)
{
    setObjectName(QStringLiteral("guide"));
    setWindowTitle(tr("User Guide"));
    m_words->setObjectName(QStringLiteral("guideWords"));
    m_words->setPlaceholderText(tr("Search the guide"));
    m_words->setAccessibleName(tr("Words to search for"));
    m_words->setToolTip(tr("Shows only pages with these words. Return jumps to the next match."));
    m_words->setClearButtonEnabled(true);
    m_words->installEventFilter(this);
    named(m_contents, "guideContents", tr("The pages of the guide."), tr("Contents"));
    m_contents->setSpacing(gap / 4);
    m_contents->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_nothing->setObjectName(QStringLiteral("guideNothing"));
    m_nothing->setWordWrap(true);
    m_nothing->setText(tr("No page has all of these words."));
    m_nothing->hide();
    named(m_text, "guideText", {}, tr("Page of the guide"));
    m_text->setSearchPaths({helpFolder(QLocale()), QStringLiteral(":/help")});
    m_text->setOpenLinks(false);
    m_text->document()->setDocumentMargin(3 * gap);

    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap);
    column->addWidget(m_words);
    column->addWidget(m_nothing);
    column->addWidget(m_contents);
    auto* parts = new QSplitter;
    parts->addWidget(left);
    parts->addWidget(m_text);
    parts->setStretchFactor(1, 1);
    parts->setSizes({contentsWidth, defaultSize.width() - contentsWidth});
    parts->setChildrenCollapsible(false);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(gap, gap, gap, gap);
    all->addWidget(parts);
    resize(defaultSize.boundedTo(screen()->availableSize() - frameRoom));

    fillContents();
    connect(m_contents, &QListWidget::currentItemChanged, this, &GuideWindow::showPage);
    connect(m_words, &QLineEdit::textChanged, this, &GuideWindow::search);
    connect(m_text, &QTextBrowser::anchorClicked, this, &GuideWindow::followLink);
}

void GuideWindow::fillContents()
{
    for (const HelpPage& page : helpPages()) {
        if (*page.command && !m_actions.get(QLatin1StringView(page.command))->isVisible())
            continue;
        auto* item = new QListWidgetItem(m_contents);
        item->setData(Id, QLatin1StringView(page.id));
        const QString text = helpText(QLatin1StringView(page.id), m_actions);
        item->setText(page.isLesson() ? tr("Lesson: %1").arg(helpTitle(text)) : helpTitle(text));
        QTextDocument plain;
        plain.setMarkdown(text);
        item->setData(Text, plain.toPlainText());
    }
}

void GuideWindow::openPage(const QString& page)
{
    m_words->clear();
    m_contents->setCurrentRow(std::max(0, rowOf(page)));
    showPage();
    show();
    raise();
    activateWindow();
}

void GuideWindow::followLink(const QUrl& url)
{
    if (rowOf(url.toString()) >= 0)
        openPage(url.toString());
}

int GuideWindow::rowOf(const QString& page) const
{
    for (int i = 0; i < m_contents->count(); ++i)
        if (m_contents->item(i)->data(Id).toString() == page)
            return i;
    return -1;
}

void GuideWindow::showPage()
{
    const QListWidgetItem* item = m_contents->currentItem();
    if (!item)
        return;
    m_text->setMarkdown(helpText(item->data(Id).toString(), m_actions));
    layOut(m_text->document(), palette().mid().color());
    removeDeadLinks();
    m_text->moveCursor(QTextCursor::Start);
    markFound();
}

/// Turns links to pages that are left out into plain text.
void GuideWindow::removeDeadLinks()
{
    const QTextCharFormat plain;
    for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
        QList<QTextFragment> dead;
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().isAnchor() && rowOf(part.fragment().charFormat().anchorHref()) < 0)
                dead << part.fragment();
        for (const QTextFragment& link : dead) {
            QTextCursor cursor(m_text->document());
            cursor.setPosition(link.position());
            cursor.setPosition(link.position() + link.length(), QTextCursor::KeepAnchor);
            cursor.setCharFormat(plain);
        }
    }
}

void GuideWindow::search()
{
    const QStringList words = m_words->text().split(u' ', Qt::SkipEmptyParts);
    const QListWidgetItem* first = nullptr;
    for (int i = 0; i < m_contents->count(); ++i) {
        QListWidgetItem* item = m_contents->item(i);
        const QString text = item->data(Text).toString();
        const bool has =
            std::ranges::all_of(words, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
        item->setHidden(!has);
        if (has && !first)
            first = item;
    }
    m_nothing->setVisible(!first);
    if (first && (!m_contents->currentItem() || m_contents->currentItem()->isHidden()))
        m_contents->setCurrentItem(const_cast<QListWidgetItem*>(first));
    markFound();
}

/// Highlights every occurrence of the first search word and scrolls to the first occurrence.
void GuideWindow::markFound()
{
    const QString word = m_words->text().section(u' ', 0, 0, QString::SectionSkipEmpty);
    QList<QTextEdit::ExtraSelection> marks;
    QTextCursor at(m_text->document());
    while (!word.isEmpty() && !(at = m_text->document()->find(word, at)).isNull()) {
        QTextEdit::ExtraSelection mark;
        mark.cursor = at;
        mark.format.setBackground(palette().highlight());
        mark.format.setForeground(palette().highlightedText());
        marks << mark;
    }
    m_text->setExtraSelections(marks);
    m_text->moveCursor(QTextCursor::Start);
    if (!marks.isEmpty())
        findNext();
}

/// Selects the next occurrence of the first search word, wrapping around at the end.
void GuideWindow::findNext()
{
    const QString word = m_words->text().section(u' ', 0, 0, QString::SectionSkipEmpty);
    if (!word.isEmpty() && !m_text->find(word)) {
        m_text->moveCursor(QTextCursor::Start);
        m_text->find(word);
    }
}

/// Handles keys in the search field: Return finds the next occurrence instead of pressing a button, and Up and Down
/// move in the contents.
bool GuideWindow::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::KeyPress)
        return QDialog::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        findNext();
        return true;
    case Qt::Key_Up:
    case Qt::Key_Down:
        QCoreApplication::sendEvent(m_contents, event);
        return true;
    default:
        return QDialog::eventFilter(watched, event);
    }
}

/// Renders the page again, because its link colours are those of the palette at the time it was set.
void GuideWindow::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showPage();
}
} // namespace ui
