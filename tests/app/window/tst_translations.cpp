// Tests that every language is complete: the files in translations/ are compared with the sources, checked for
// consistency, and used in the program.
#include "ui/actions/actions.h"
#include "ui/classroom/classroom_dialog.h"
#include "ui/model/objects_bar.h"
#include "ui/model/unit_bar.h"
#include "ui/preferences/preferences_dialog.h"

#include "tests/support/test_main.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDir>
#include <QFontDatabase>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QProcess>
#include <QRawFont>
#include <QRegularExpression>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

#include <algorithm>

namespace
{
struct Message
{
    QString context, source, comment, type;
    QStringList translations; ///< more than one entry: plural forms
    bool isPlural = false;

    QString key() const { return context + QStringLiteral(" | ") + source + QStringLiteral(" | ") + comment; }
};

struct Catalogue
{
    QString language, error;
    QList<Message> messages;

    QStringList keys() const
    {
        QStringList all;
        for (const Message& message : messages)
            all << message.key();
        all.sort();
        return all;
    }
};

Message readMessage(QXmlStreamReader& xml, const QString& context)
{
    Message message;
    message.context = context;
    message.isPlural = xml.attributes().value(QStringLiteral("numerus")) == QStringLiteral("yes");
    while (xml.readNextStartElement()) {
        if (xml.name() == QStringLiteral("source")) {
            message.source = xml.readElementText();
        } else if (xml.name() == QStringLiteral("comment")) {
            message.comment = xml.readElementText();
        } else if (xml.name() == QStringLiteral("translation")) {
            message.type = xml.attributes().value(QStringLiteral("type")).toString();
            if (!message.isPlural)
                message.translations << xml.readElementText();
            else
                while (xml.readNextStartElement())
                    message.translations << xml.readElementText();
        } else {
            xml.skipCurrentElement();
        }
    }
    return message;
}

Catalogue readCatalogue(const QString& path)
{
    Catalogue catalogue;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        catalogue.error = file.errorString();
        return catalogue;
    }
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QStringLiteral("TS"))
            catalogue.language = xml.attributes().value(QStringLiteral("language")).toString();
        else if (xml.name() == QStringLiteral("name"))
            context = xml.readElementText();
        else if (xml.name() == QStringLiteral("message"))
            catalogue.messages << readMessage(xml, context);
    }
    catalogue.error = xml.error() == QXmlStreamReader::NoError ? QString() : xml.errorString();
    return catalogue;
}

QString pathOf(const QString& language)
{
    return QStringLiteral(FETTLE_SOURCE_DIR "/translations/fettle_%1.ts").arg(language);
}

QStringList languages()
{
    QStringList all;
    for (const QString& name :
         QDir(QStringLiteral(FETTLE_SOURCE_DIR "/translations")).entryList({QStringLiteral("*.ts")}))
        all << name.mid(7).chopped(3);
    return all;
}

/// Returns the marks of a text that a translation must contain as often as the source: "%1", "%L2", "%n", "[*]", "(*)"
/// of file filters, and "…".
QStringList marks(const QString& text)
{
    static const QRegularExpression mark(QStringLiteral(R"(%L?(\d|n)|\[\*\]|\(\*\)|…)"));
    QStringList found;
    for (auto i = mark.globalMatch(text); i.hasNext();)
        found << i.next().captured();
    found.sort();
    return found;
}

/// Returns the mnemonic letters, each marked by a preceding '&'. "&&" is a literal ampersand.
QStringList mnemonics(const QString& text)
{
    static const QRegularExpression mnemonic(QStringLiteral("&(\\w)"), QRegularExpression::UseUnicodePropertiesOption);
    QStringList found;
    for (auto i = mnemonic.globalMatch(QString(text).remove(QStringLiteral("&&"))); i.hasNext();)
        found << i.next().captured(1).toUpper();
    return found;
}

/// A translation of the program that is installed for the lifetime of this object.
struct Translation
{
    explicit Translation(const QString& language)
        : isLoaded(translator.load(QStringLiteral("fettle_") + language, QStringLiteral(FETTLE_QM_DIR)))
    {
        QCoreApplication::installTranslator(&translator);
    }

    QTranslator translator;
    bool isLoaded;
};

/// Returns the mnemonics of the controls in a part of a window.
QStringList mnemonicsIn(const QWidget& part)
{
    QStringList found;
    for (const auto* label : part.findChildren<QLabel*>())
        if (label->buddy())
            found += mnemonics(label->text());
    for (const auto* button : part.findChildren<QAbstractButton*>())
        found += mnemonics(button->text());
    return found;
}

QString edges(const QString& text)
{
    return QStringLiteral("%1%2").arg(text.startsWith(u' ') ? 1 : 0).arg(text.endsWith(u'\n') ? 1 : 0);
}

QString fault(const Message& message, const QString& translation)
{
    if (translation.trimmed().isEmpty())
        return QStringLiteral("is empty");
    if (marks(translation) != marks(message.source))
        return QStringLiteral("has other marks (%1, [*], …) than its source");
    if (mnemonics(translation).size() != mnemonics(message.source).size())
        return QStringLiteral("has other mnemonics than its source");
    if (edges(translation) != edges(message.source))
        return QStringLiteral("begins or ends with other space than its source");
    return {};
}

qsizetype formsIn(const QString& language)
{
    return language.startsWith(QStringLiteral("zh")) ? 1 : 2;
}

/// Returns the program's output in a language. The system need not have a locale for it.
QString fettle(const QStringList& arguments, const QString& language)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.remove(QStringLiteral("LC_ALL"));
    environment.insert(QStringLiteral("LANG"), QStringLiteral("C.UTF-8"));
    environment.insert(QStringLiteral("LANGUAGE"), language);
    QProcess process;
    process.setProcessEnvironment(environment);
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(QStringLiteral(FETTLE_PROGRAM), arguments);
    process.waitForFinished();
    return QString::fromUtf8(process.readAll());
}
} // namespace

class TestTranslations : public QObject
{
    Q_OBJECT

public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

private Q_SLOTS:
    void languages_areThere();
    void fault_isFound_data();
    void fault_isFound();
    void everySource_isThere_data() { addLanguages(); }
    void everySource_isThere();
    void everyMessage_isTranslated_data() { addLanguages(); }
    void everyMessage_isTranslated();
    void everyContext_isAClass_data() { addLanguages(); }
    void everyContext_isAClass();
    void chineseHasAFont();
    void mnemonics_areUniqueInAMenu_data() { addLanguages(); }
    void mnemonics_areUniqueInAMenu();
    void mnemonics_areUniqueInADialog_data() { addLanguages(); }
    void mnemonics_areUniqueInADialog();
    void mnemonics_areUniqueInBars_data() { addLanguages(); }
    void mnemonics_areUniqueInBars();
    void menuKeys_areInMenusOnly();
    void theProgram_speaksIt_data();
    void theProgram_speaksIt();
    void theProgram_countsInEnglish();

private:
    static void addLanguages();
};

void TestTranslations::addLanguages()
{
    QTest::addColumn<QString>("language");
    for (const QString& language : languages())
        QTest::newRow(qPrintable(language)) << language;
}

void TestTranslations::languages_areThere()
{
    QCOMPARE(languages(), QStringList({QStringLiteral("de"), QStringLiteral("en"), QStringLiteral("zh_CN")}));
    for (const QString& language : languages()) {
        const Catalogue catalogue = readCatalogue(pathOf(language));
        QCOMPARE(catalogue.error, QString());
        QCOMPARE(catalogue.language, language);
    }
}

void TestTranslations::fault_isFound_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("translation");
    QTest::addColumn<bool>("isFault");
    const auto row = [](const char* name, const char* source, const char* translation, bool isFault) {
        QTest::newRow(name) << QString::fromUtf8(source) << QString::fromUtf8(translation) << isFault;
    };
    row("good", "&Undo %1", "&Rückgängig: %1", false);
    row("in another order", "%1 of %2", "%2: %1", false);
    row("key in brackets", "&Open…", "打开(&O)…", false);
    row("empty", "Undo", " ", true);
    row("lost", "%1 of %2", "%1", true);
    row("twice", "%1 of %2", "%1 %2 %1", true);
    row("not localised", "%Ln vertices", "%n Eckpunkte", true);
    row("no key", "&Undo", "Rückgängig", true);
    row("key to nothing", "&Undo", "Rückgängig& ", true);
    row("no ellipsis", "&Open…", "Ö&ffnen", true);
    row("no place for the star", "%1[*] – Fettle", "%1 – Fettle", true);
    row("filter", "All files (*)", "Alle Dateien", true);
    row("no space before the unit", " mm", "mm", true);
}

void TestTranslations::fault_isFound()
{
    QFETCH(QString, source);
    QFETCH(QString, translation);
    QFETCH(bool, isFault);
    Message message;
    message.source = source;
    QCOMPARE(!fault(message, translation).isEmpty(), isFault);
}

/// The file must contain exactly the texts that lupdate finds in the sources. The target update_translations updates
/// it.
void TestTranslations::everySource_isThere()
{
    QFETCH(QString, language);
    const QTemporaryDir folder;
    const QString fresh = folder.filePath(QStringLiteral("fettle_%1.ts").arg(language));
    QStringList arguments{QStringLiteral("-silent"), QStringLiteral("-locations"), QStringLiteral("none"),
                          QStringLiteral("-I"), QStringLiteral(FETTLE_SOURCE_DIR)};
    if (language == QStringLiteral("en"))
        arguments << QStringLiteral("-pluralonly");
    for (const char* room : {"ui", "vr", "app"})
        arguments << QStringLiteral(FETTLE_SOURCE_DIR "/") + QString::fromLatin1(room);
    QProcess lupdate;
    lupdate.setProcessChannelMode(QProcess::MergedChannels);
    lupdate.start(QStringLiteral(FETTLE_LUPDATE), arguments << QStringLiteral("-ts") << fresh);
    QVERIFY(lupdate.waitForFinished());
    QVERIFY2(lupdate.exitCode() == 0, lupdate.readAll().constData());
    const QStringList wanted = readCatalogue(fresh).keys(), there = readCatalogue(pathOf(language)).keys();
    QVERIFY(!wanted.isEmpty());
    for (const QString& key : wanted)
        QVERIFY2(there.contains(key), qPrintable(QStringLiteral("not in the file: ") + key));
    QCOMPARE(there, wanted);
}

void TestTranslations::everyMessage_isTranslated()
{
    QFETCH(QString, language);
    for (const Message& message : readCatalogue(pathOf(language)).messages) {
        QVERIFY2(message.type.isEmpty(), qPrintable(message.key() + QStringLiteral(": ") + message.type));
        QCOMPARE(message.translations.size(), message.isPlural ? formsIn(language) : 1);
        for (const QString& translation : message.translations) {
            const QString found = fault(message, translation);
            QVERIFY2(found.isEmpty(),
                     qPrintable(QStringLiteral("\"%1\", for \"%2\", %3").arg(translation, message.source, found)));
        }
    }
}

/// Texts are looked up by class name. If lupdate misreads a source, it writes another context.
void TestTranslations::everyContext_isAClass()
{
    QFETCH(QString, language);
    static const QRegularExpression ofARoom(QStringLiteral("^(ui|vr|app)::[A-Z]\\w+$"));
    for (const Message& message : readCatalogue(pathOf(language)).messages)
        QVERIFY2(ofARoom.match(message.context).hasMatch(), qPrintable(message.key()));
}

/// Some installed font must contain all Chinese characters; run.sh installs one.
void TestTranslations::chineseHasAFont()
{
    QSet<QChar> letters;
    for (const Message& message : readCatalogue(pathOf(QStringLiteral("zh_CN"))).messages)
        for (const QString& translation : message.translations)
            for (const QChar letter : translation)
                if (letter.isLetter())
                    letters.insert(letter);
    QVERIFY(letters.size() > 300);
    const QStringList families = QFontDatabase::families(QFontDatabase::SimplifiedChinese);
    QVERIFY(std::ranges::any_of(families, [&](const QString& family) {
        const QRawFont font = QRawFont::fromFont(QFont(family), QFontDatabase::SimplifiedChinese);
        return std::ranges::all_of(letters, [&](QChar letter) { return font.supportsCharacter(letter); });
    }));
}

void TestTranslations::mnemonics_areUniqueInAMenu()
{
    QFETCH(QString, language);
    const Translation translation(language);
    QVERIFY(translation.isLoaded);
    QMainWindow window;
    const ui::Actions actions(&window);
    QStringList titles;
    for (const ui::MenuId id :
         {ui::MenuId::File, ui::MenuId::Edit, ui::MenuId::Sculpt, ui::MenuId::Tool, ui::MenuId::Mask, ui::MenuId::Model,
          ui::MenuId::Parts, ui::MenuId::Area, ui::MenuId::View, ui::MenuId::Vr, ui::MenuId::Help}) {
        QStringList keys;
        if (id == ui::MenuId::Sculpt)
            keys += mnemonics(actions.menuTitle(ui::MenuId::Tool)) + mnemonics(actions.menuTitle(ui::MenuId::Mask));
        if (id == ui::MenuId::Model)
            keys += mnemonics(actions.menuTitle(ui::MenuId::Parts)) + mnemonics(actions.menuTitle(ui::MenuId::Area));
        if (id != ui::MenuId::Tool && id != ui::MenuId::Mask && id != ui::MenuId::Parts && id != ui::MenuId::Area)
            titles += mnemonics(actions.menuTitle(id));
        QMenu menu;
        actions.fill(&menu, id);
        for (const QAction* action : menu.actions())
            keys += mnemonics(action->text());
        QVERIFY(!keys.isEmpty());
        QVERIFY2(keys.removeDuplicates() == 0, qPrintable(actions.menuTitle(id)));
    }
    QCOMPARE(titles.size(), 7);
    QCOMPARE(titles.removeDuplicates(), 0);
    for (const ui::ActionInfo& row : ui::actionTable())
        for (const QString& title : titles)
            QVERIFY2(!actions.get(QLatin1StringView(row.id))
                          ->shortcuts()
                          .contains(QKeySequence(QStringLiteral("Alt+") + title)),
                     row.id);
}

void TestTranslations::mnemonics_areUniqueInADialog()
{
    QFETCH(QString, language);
    const Translation translation(language);
    QVERIFY(translation.isLoaded);
    QMainWindow window;
    const ui::Actions actions(&window);
    const ui::ClassroomDialog classroom(&window, actions, {});
    QStringList keys = mnemonicsIn(classroom);
    QVERIFY(keys.size() > 15);
    QVERIFY2(keys.removeDuplicates() == 0, qPrintable(keys.join(u' ')));
    const ui::PreferencesDialog preferences({}, actions, &window);
    const auto* pages = preferences.findChild<QTabWidget*>();
    for (int page = 0; page < pages->count(); ++page) {
        keys = mnemonicsIn(*pages->widget(page)) + mnemonicsIn(*preferences.findChild<QDialogButtonBox*>());
        for (int tab = 0; tab < pages->count(); ++tab)
            keys += mnemonics(pages->tabText(tab));
        QVERIFY(keys.size() > pages->count());
        QVERIFY2(keys.removeDuplicates() == 0, qPrintable(pages->tabText(page) + u' ' + keys.join(u' ')));
    }
}

/// Tests that bars that can be over the view at the same time, and the menus, share no key.
void TestTranslations::mnemonics_areUniqueInBars()
{
    QFETCH(QString, language);
    const Translation translation(language);
    QVERIFY(translation.isLoaded);
    QMainWindow window;
    window.setCentralWidget(new QWidget);
    const ui::Actions actions(&window);
    for (const core::UnitDoubt guess : {core::UnitDoubt::Inches, core::UnitDoubt::Metres})
        for (const bool areParts : {false, true}) {
            const ui::UnitBar unit({QStringLiteral("a.obj"), 1.5, guess}, &window);
            const ui::ObjectsBar objects(QStringLiteral("a.obj"), {2, areParts}, &window);
            QStringList keys = mnemonicsIn(unit) + mnemonicsIn(objects);
            QCOMPARE(keys.size(), 6);
            for (const ui::MenuId id : {ui::MenuId::File, ui::MenuId::Edit, ui::MenuId::Sculpt, ui::MenuId::Model,
                                        ui::MenuId::View, ui::MenuId::Vr, ui::MenuId::Help})
                keys += mnemonics(actions.menuTitle(id));
            QVERIFY2(keys.removeDuplicates() == 0, qPrintable(keys.join(u' ')));
        }
}

void TestTranslations::menuKeys_areInMenusOnly()
{
    const Translation translation(QStringLiteral("zh_CN"));
    QVERIFY(translation.isLoaded);
    QMainWindow window;
    const ui::Actions actions(&window);
    for (const ui::ActionInfo& row : ui::actionTable()) {
        const QAction* action = actions.get(QLatin1StringView(row.id));
        QVERIFY2(action->text().contains(QStringLiteral("(&")), qPrintable(action->text()));
        QVERIFY2(!action->iconText().contains(QLatin1Char('(')), qPrintable(action->iconText()));
        const QString key = action->shortcut().toString(QKeySequence::NativeText);
        const QString name = action->iconText() + (key.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(key));
        QVERIFY2(action->toolTip().startsWith(name + QLatin1Char('\n')), qPrintable(action->toolTip()));
    }
}

/// Excludes English, which is in the sources except for plural forms.
void TestTranslations::theProgram_speaksIt_data()
{
    QTest::addColumn<QString>("language");
    for (const QString& language : languages())
        if (language != QStringLiteral("en"))
            QTest::newRow(qPrintable(language)) << language;
}

/// Translations are loaded from ":/i18n" in the same way as in main().
void TestTranslations::theProgram_speaksIt()
{
    QFETCH(QString, language);
    for (const Message& message : readCatalogue(pathOf(language)).messages) {
        if (!message.source.startsWith(QStringLiteral("Fettle sculpts")))
            continue;
        QVERIFY(message.translations.first() != message.source);
        QVERIFY(fettle({QStringLiteral("--help")}, language)
                    .contains(message.translations.first().section(QStringLiteral("%1"), 0, 0)));
        return;
    }
    QFAIL("the help is missing");
}

void TestTranslations::theProgram_countsInEnglish()
{
    const QStringList one{QStringLiteral("convert"), QStringLiteral("a")},
        three = one + QStringList{QStringLiteral("b"), QStringLiteral("c")};
    QVERIFY(fettle(one, QStringLiteral("en")).contains(QStringLiteral("OUT; 1 was given")));
    QVERIFY(fettle(three, QStringLiteral("en")).contains(QStringLiteral("OUT; 3 were given")));
    QVERIFY(fettle(one, QStringLiteral("en:de")).contains(QStringLiteral("OUT; 1 was given")));
}

FETTLE_TEST(TestTranslations, QApplication)
#include "tst_translations.moc"
