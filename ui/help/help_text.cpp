#include "ui/help/help_text.h"

#include "ui/actions/actions.h"

#include <QAction>
#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <array>

namespace ui
{
namespace
{
constexpr std::array<HelpPage, 34> pages{{{"first-steps"},
                                          {"lesson-vase", "lesson-vase.png"},
                                          {"lesson-head", "lesson-head.png"},
                                          {"lesson-tablet", "lesson-tablet.png"},
                                          {"lessons"},
                                          {"view"},
                                          {"tools"},
                                          {"presets"},
                                          {"topology"},
                                          {"symmetry"},
                                          {"mask"},
                                          {"colour"},
                                          {"model"},
                                          {"parts"},
                                          {"open", "", "file.open"},
                                          {"repair", "", "file.open"},
                                          {"files", "", "file.save"},
                                          {"export", "", "file.exportFor"},
                                          {"print", "", "model.printCheck"},
                                          {"preview", "", "file.exportDrawing"},
                                          {"time-lapse", "", "file.timeLapse"},
                                          {"history"},
                                          {"recovery", "", "file.open"},
                                          {"keys"},
                                          {"pen"},
                                          {"vr"},
                                          {"controllers"},
                                          {"vr-sculpting"},
                                          {"simulator"},
                                          {"classroom", "", "edit.classroom"},
                                          {"class-work", "", "edit.classroom"},
                                          {"record-lesson", "", "lesson.record"},
                                          {"report", "", "file.report"},
                                          {"problems"}}};

struct HelpText
{
    Q_DECLARE_TR_FUNCTIONS(ui::HelpText)
};

/// Returns null if the table has no such action.
const ActionInfo* rowOf(const QString& id)
{
    const auto row = std::ranges::find_if(actionTable(),
                                          [&](const ActionInfo& action) { return id == QLatin1StringView(action.id); });
    return row != actionTable().end() ? &*row : nullptr;
}

/// Returns the key as inline code, in which Markdown has no special characters.
QString asKey(const QString& key)
{
    return u'`' + key + u'`';
}

QString shortcutText(const ActionInfo& row, const Actions& actions)
{
    QStringList keys;
    for (const QKeySequence& key : actions.get(QLatin1StringView(row.id))->shortcuts())
        keys << asKey(key.toString(QKeySequence::NativeText));
    return keys.isEmpty() ? HelpText::tr("(no key)") : keys.join(HelpText::tr(" or ", "one key or the other"));
}

QString menuPathText(const ActionInfo& row, const Actions& actions)
{
    QList<MenuId> way{row.menu};
    if (row.menu == MenuId::New)
        way.prepend(MenuId::File);
    if (row.menu == MenuId::Tool || row.menu == MenuId::Mask)
        way.prepend(MenuId::Sculpt);
    if (row.menu == MenuId::Area)
        way.prepend(MenuId::Model);
    if (row.menu == MenuId::Turn || row.menu == MenuId::Material || row.menu == MenuId::Background)
        way.prepend(MenuId::View);
    QStringList words;
    for (const MenuId menu : way)
        words << Actions::plain(actions.menuTitle(menu));
    words << actions.get(QLatin1StringView(row.id))->iconText();
    return QStringLiteral("**%1**").arg(words.join(QStringLiteral(" › ")));
}

QString fill(const QString& what, const QString& id, const Actions& actions)
{
    const ActionInfo* row = rowOf(id);
    if (what == QLatin1StringView("invert"))
        return asKey(Actions::modifierName(mouseModifiers(actions.keys().preset).invert));
    if (what == QLatin1StringView("smooth"))
        return asKey(Actions::modifierName(Qt::ShiftModifier));
    if (!row)
        return {};
    return what == QLatin1StringView("key")    ? shortcutText(*row, actions)
           : what == QLatin1StringView("menu") ? menuPathText(*row, actions)
                                               : QString();
}
} // namespace

std::span<const HelpPage> helpPages()
{
    return pages;
}

QString helpFolder(const QLocale& locale)
{
    for (QString language : locale.uiLanguages()) {
        language.replace(u'-', u'_');
        for (const QString& name : {language, language.section(u'_', 0, 0)})
            if (const QString folder = QStringLiteral(":/help/") + name; QFile::exists(folder))
                return folder;
    }
    return QStringLiteral(":/help/en");
}

QString helpText(const QString& id, const Actions& actions)
{
    QFile file(QStringLiteral("%1/%2.md").arg(helpFolder(QLocale()), id));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString source = QString::fromUtf8(file.readAll());
    static const QRegularExpression place(QStringLiteral(R"(\{([a-z]+)(?::([\w.]+))?\})"));
    QString text;
    qsizetype done = 0;
    for (auto match = place.globalMatch(source); match.hasNext();) {
        const QRegularExpressionMatch found = match.next();
        const QString words = fill(found.captured(1), found.captured(2), actions);
        text += QStringView(source).mid(done, found.capturedStart() - done);
        text += words.isEmpty() ? found.captured() : words;
        done = found.capturedEnd();
    }
    text += QStringView(source).mid(done);
    return text;
}

QString helpTitle(const QString& text)
{
    return text.section(u'\n', 0, 0).mid(2);
}
} // namespace ui
