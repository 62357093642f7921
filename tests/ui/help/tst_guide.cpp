#include "ui/actions/actions.h"
#include "ui/help/guide_window.h"
#include "ui/help/help_text.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMainWindow>
#include <QRegularExpression>
#include <QTextBrowser>

using ui::HelpPage;

namespace
{
const QStringList languages = {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("zh_CN")};

QString source(const QString& language, const QString& page)
{
    QFile file(QStringLiteral(":/help/%1/%2.md").arg(language, page));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Returns the picture that the guide would show: the language's own, or else the common one.
QImage pictureOf(const QString& language, const QString& path)
{
    const QImage own(QStringLiteral(":/help/%1/%2").arg(language, path));
    return own.isNull() ? QImage(QStringLiteral(":/help/") + path) : own;
}

QStringList found(const QString& text, const QString& pattern)
{
    QStringList all;
    for (auto match = QRegularExpression(pattern).globalMatch(text); match.hasNext();)
        all << match.next().captured(1);
    all.sort();
    return all;
}

/// The guide window with its own main window and actions.
struct Fixture
{
    QMainWindow window;
    ui::Actions actions{&window};
    ui::GuideWindow guide{actions, &window};

    template <class Widget> Widget* child(const char* name)
    {
        return guide.findChild<Widget*>(QLatin1StringView(name));
    }
    QListWidget* contents() { return child<QListWidget>("guideContents"); }
    QString text() { return child<QTextBrowser>("guideText")->toPlainText(); }
    int shown()
    {
        int count = 0;
        for (int i = 0; i < contents()->count(); ++i)
            count += !contents()->item(i)->isHidden();
        return count;
    }
};
} // namespace

class TestGuide : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    /// All languages have the same pages, and there are no unused pages.
    void languagesSayTheSame()
    {
        for (const QString& language : languages)
            QCOMPARE(QDir(QStringLiteral(":/help/") + language).entryList({QStringLiteral("*.md")}).size(),
                     qsizetype(ui::helpPages().size()));
        for (const HelpPage& page : ui::helpPages()) {
            const QString id = QLatin1StringView(page.id), english = source(QStringLiteral("en"), id);
            for (const QString& language : languages) {
                const QString text = source(language, id);
                QVERIFY2(text.startsWith(QStringLiteral("# ")), page.id);
                for (const char* pattern :
                     {R"(!\[[^\]]*\]\(([^)]*)\))", R"([^!]\[[^\]]*\]\(([^)]*)\))", R"(\{([^}]*)\})"})
                    QCOMPARE(found(text, QLatin1StringView(pattern)), found(english, QLatin1StringView(pattern)));
                QCOMPARE(text.count(QStringLiteral("\n|")), english.count(QStringLiteral("\n|")));
                QCOMPARE(text.count(QStringLiteral("\n- ")), english.count(QStringLiteral("\n- ")));
                if (language != QStringLiteral("en"))
                    QVERIFY2(text != english, page.id);
            }
        }
    }

    void everyPlaceLinkAndPictureIsThere()
    {
        QSet<QString> ids, pages;
        for (const ui::ActionInfo& row : ui::actionTable())
            ids << QLatin1StringView(row.id);
        for (const HelpPage& page : ui::helpPages())
            pages << QLatin1StringView(page.id);
        for (const HelpPage& page : ui::helpPages()) {
            const QString text = source(QStringLiteral("en"), QLatin1StringView(page.id));
            for (const QString& place : found(text, QStringLiteral(R"(\{([^}]*)\})"))) {
                const QString what = place.section(u':', 0, 0), id = place.section(u':', 1);
                const bool isHeld = place == QStringLiteral("invert") || place == QStringLiteral("smooth");
                QVERIFY2(isHeld ||
                             ((what == QStringLiteral("key") || what == QStringLiteral("menu")) && ids.contains(id)),
                         qPrintable(place));
            }
            for (const QString& link : found(text, QStringLiteral(R"([^!]\[[^\]]*\]\(([^)]*)\))")))
                QVERIFY2(pages.contains(link), qPrintable(link));
            for (const QString& picture : found(text, QStringLiteral(R"(!\[[^\]]*\]\(([^)]*)\))")))
                for (const QString& language : languages)
                    QVERIFY2(pictureOf(language, picture).width() > 100, qPrintable(language + u' ' + picture));
            if (page.isLesson())
                QVERIFY2(text.contains(QLatin1StringView(page.picture)), page.id);
        }
    }

    /// Each page fits on one or two screens, and each picture of a language is used on a page.
    void pagesAreShort_andShowAllPictures()
    {
        QSet<QString> shown;
        for (const HelpPage& page : ui::helpPages()) {
            const QString id = QLatin1StringView(page.id);
            for (const QString& language : languages)
                QVERIFY2(source(language, id).count(u'\n') <= 60, qPrintable(language + u' ' + id));
            for (const QString& path :
                 found(source(QStringLiteral("en"), id), QStringLiteral(R"(!\[[^\]]*\]\(([^)]*)\))")))
                shown << path.section(u'/', -1);
        }
        for (const QString& language : languages)
            for (const QString& file : QDir(QStringLiteral(":/help/%1/pictures").arg(language)).entryList())
                QVERIFY2(shown.contains(file), qPrintable(language + u' ' + file));
    }

    /// No page contains jargon that users of other sculpting programs would not understand.
    void wordsAreThoseOfTheTrade()
    {
        const QRegularExpression odd(
            QStringLiteral(R"(\b(anew|wands?|mend(s|ed|ing)?|taken back|does again|fine fettle|sound body)\b)"),
            QRegularExpression::CaseInsensitiveOption);
        for (const HelpPage& page : ui::helpPages()) {
            const QString odds = odd.match(source(QStringLiteral("en"), QLatin1StringView(page.id))).captured();
            QVERIFY2(odds.isEmpty(), qPrintable(QLatin1StringView(page.id) + QStringLiteral(": ") + odds));
        }
    }

    /// The displayed pages contain no Markdown marks or placeholders.
    void everyPageIsReadable()
    {
        for (const QString& language : languages) {
            QLocale::setDefault(QLocale(language));
            QCOMPARE(ui::helpFolder(QLocale()), QStringLiteral(":/help/") + language);
            Fixture fixture;
            for (int i = 0; i < fixture.contents()->count(); ++i) {
                fixture.contents()->setCurrentRow(i);
                const QString where = language + u' ' + fixture.contents()->item(i)->text();
                QVERIFY2(fixture.text().size() > 100 && !fixture.contents()->item(i)->text().isEmpty(),
                         qPrintable(where));
                for (const char* mark : {"**", "{", "}", "](", "`", "|--"})
                    QVERIFY2(!fixture.text().contains(QLatin1StringView(mark)),
                             qPrintable(where + QLatin1StringView(mark)));
            }
        }
        QCOMPARE(ui::helpFolder(QLocale(QStringLiteral("fr"))), QStringLiteral(":/help/en"));
        QCOMPARE(ui::helpFolder(QLocale(QStringLiteral("de_AT"))), QStringLiteral(":/help/de"));
    }

    void keysAreThoseOfNow()
    {
        Fixture fixture;
        fixture.guide.openPage(QStringLiteral("tools"));
        QVERIFY(!fixture.text().contains(QStringLiteral("Alt")));
        fixture.actions.setKeys(
            {ui::ShortcutPreset::ZBrush,
             {{QStringLiteral("tool.pull"), QStringLiteral("Ctrl+Alt+9")}, {QStringLiteral("tool.push"), {}}}});
        fixture.guide.openPage(QStringLiteral("tools"));
        QVERIFY(fixture.text().contains(QStringLiteral("Ctrl+Alt+9")) &&
                fixture.text().contains(QStringLiteral("no key")));
        QVERIFY(ui::helpText(QStringLiteral("tools"), fixture.actions).contains(QStringLiteral("`Alt`")));
    }

    void wordsAreSought()
    {
        Fixture fixture;
        fixture.guide.openPage({});
        auto* words = fixture.child<QLineEdit>("guideWords");
        QCOMPARE(fixture.shown(), int(ui::helpPages().size()));
        QTest::keyClicks(words, QStringLiteral("groove"));
        QVERIFY(fixture.shown() > 0 && fixture.shown() < 5 && !fixture.contents()->currentItem()->isHidden());
        QVERIFY(fixture.text().contains(QStringLiteral("groove")));
        auto* text = fixture.child<QTextBrowser>("guideText");
        QCOMPARE(text->textCursor().selectedText(), QStringLiteral("groove"));
        QVERIFY(!text->extraSelections().isEmpty());
        QTest::keyClick(words, Qt::Key_Return);
        QCOMPARE(text->textCursor().selectedText(), QStringLiteral("groove"));
        QVERIFY(fixture.guide.isVisible());
        QTest::keyClicks(words, QStringLiteral(" xyzzy"));
        QCOMPARE(fixture.shown(), 0);
        QVERIFY(fixture.child<QLabel>("guideNothing")->isVisible());
        words->clear();
        QCOMPARE(fixture.shown(), int(ui::helpPages().size()));
        QVERIFY(text->extraSelections().isEmpty());
    }

    void pagesAreTurnedByKeysAndLinks()
    {
        Fixture fixture;
        fixture.guide.openPage({});
        const QString first = fixture.text();
        QTest::keyClick(fixture.child<QLineEdit>("guideWords"), Qt::Key_Down);
        QVERIFY(fixture.text() != first);
        fixture.guide.openPage(QStringLiteral("symmetry"));
        Q_EMIT fixture.child<QTextBrowser>("guideText")->anchorClicked(QUrl(QStringLiteral("lesson-vase")));
        QCOMPARE(fixture.contents()->currentRow(), 1);
        QTest::keyClick(&fixture.guide, Qt::Key_Escape);
        QVERIFY(!fixture.guide.isVisible());
    }
};

FETTLE_TEST(TestGuide, ui::TestApplication)
#include "tst_guide.moc"
