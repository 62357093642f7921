#include "ui/widgets/dialog_helpers.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
/// A scroll area as large as its page, but no higher than the screen allows.
class PageArea : public QScrollArea
{
public:
    explicit PageArea(QWidget* page)
    {
        setFrameShape(QFrame::NoFrame);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setWidgetResizable(true);
        setWidget(page);
    }

    QSize sizeHint() const override
    {
        constexpr int others = 200; // pixels for the rest of the dialog and its frame
        const QSize whole = widget()->sizeHint().expandedTo(widget()->minimumSizeHint());
        const int available = std::max(screen()->availableGeometry().height() - others, minimumSizeHint().height());
        const bool isWhole = whole.height() <= available;
        return {whole.width() + (isWhole ? 0 : verticalScrollBar()->sizeHint().width()),
                std::min(whole.height(), available)};
    }
    QSize minimumSizeHint() const override
    {
        constexpr int lines = 6;
        return {widget()->minimumSizeHint().width(), lines * fontMetrics().lineSpacing()};
    }
};
} // namespace

QVBoxLayout* beginDialog(QDialog* dialog, const char* name, const QString& title)
{
    dialog->setObjectName(QLatin1StringView(name));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(dialogMargin, dialogMargin, dialogMargin, dialogMargin);
    column->setSpacing(dialogGap);
    column->setSizeConstraint(QLayout::SetFixedSize);
    return column;
}

QVBoxLayout* addScrolledPage(QVBoxLayout* column)
{
    auto* page = new QWidget;
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(dialogGap);
    column->addWidget(new PageArea(page));
    return rows;
}

QLabel* dialogText(const QString& sentences, int width)
{
    auto* label = new QLabel(sentences);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setFixedWidth(width);
    return label;
}

QPushButton* addDialogButtons(QDialog* dialog, const QString& verb)
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton* accept = buttons->addButton(verb, QDialogButtonBox::AcceptRole);
    dialog->layout()->addWidget(buttons);
    accept->setDefault(true);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    return accept;
}
} // namespace ui
