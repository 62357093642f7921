#include "ui/classroom/names_field.h"

#include "ui/classroom/classroom.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spacing.h"

#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include <algorithm>

namespace ui
{
namespace
{
constexpr int nameLines = 3;
constexpr qsizetype maxNamesInWord = 4;

/// Returns the lines that contain a name; repeated names are kept.
QStringList linesOf(const QString& text)
{
    QStringList lines;
    for (QString line : text.split(u'\n'))
        if (const QString name = line.replace(u';', u' ').simplified(); !name.isEmpty())
            lines << name;
    return lines;
}
} // namespace

NamesField::NamesField()
    : m_text(named(new QPlainTextEdit, "classNames",
                   tr("One name per line; you can paste a list. Pupils choose their name; those who had a turn today "
                      "are marked.")))
    , m_word(named(new QLabel, "classNamesWord"))
{
    m_text->setPlaceholderText(tr("One name per line. Without names, pupils type theirs."));
    m_text->setTabChangesFocus(true);
    m_text->setFixedHeight(nameLines * m_text->fontMetrics().lineSpacing() + 2 * gap);
    m_word->setTextFormat(Qt::PlainText);
    m_word->setWordWrap(true);
    m_word->hide();
    setFocusProxy(m_text);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(gap / 2);
    column->addWidget(m_text);
    column->addWidget(m_word);
    connect(m_text, &QPlainTextEdit::textChanged, this, &NamesField::showWord);
}

void NamesField::setNames(const QStringList& names)
{
    m_text->setPlainText(names.join(u'\n'));
}

QStringList NamesField::names() const
{
    QStringList names = linesOf(m_text->toPlainText());
    names.removeDuplicates();
    return names;
}

QString NamesField::fault() const
{
    const QStringList typed = names();
    const auto tooLong =
        std::ranges::find_if(typed, [](const QString& name) { return name.size() > maxPupilNameLength; });
    if (tooLong != typed.end())
        return tr("\"%1\" is longer than %2 characters.")
            .arg(tooLong->left(maxPupilNameLength) + u'…', QString::number(maxPupilNameLength));
    if (typed.size() > maxPupilNames)
        return tr("A class has at most %1 names; these are %2.").arg(maxPupilNames).arg(typed.size());
    return {};
}

QStringList NamesField::repeated() const
{
    QStringList seen, repeated;
    for (const QString& name : linesOf(m_text->toPlainText()))
        (seen.contains(name) ? repeated : seen) << name;
    repeated.removeDuplicates();
    return repeated;
}

void NamesField::showWord()
{
    QString word = fault();
    QStringList twice = repeated();
    if (word.isEmpty() && !twice.isEmpty()) {
        if (twice.size() > maxNamesInWord)
            twice = twice.first(maxNamesInWord) << QStringLiteral("…");
        word = tr("In the list more than once, and counted once: %1.").arg(twice.join(QStringLiteral(", ")));
    }
    m_word->setText(word);
    m_word->setVisible(!word.isEmpty());
}
} // namespace ui
