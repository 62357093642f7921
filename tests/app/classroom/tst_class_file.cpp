#include "app/classroom/class_file.h"
#include "app/classroom/class_pin.h"
#include "app/lesson/lesson_library.h"
#include "app/model/model_loader.h"

#include "tests/support/test_main.h"
#include "tests/support/unwritable_places.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace
{
const QByteArray pinLine = "pin = pbkdf2-sha256:1:00ff:" + QByteArray(64, 'a') + '\n';

QByteArray whole()
{
    return "# for 5b\n[class]\ntitle = Klasse 5b, Ton & Töne\nfolder = works\nstarters = vase, ball\ntools = smooth, "
           "pull\n"
           "turn_minutes = 30\nwarning_minutes=5\nfull_screen = no\nlanguage = de\nquestions = yes\n" +
           pinLine;
}

/// A temporary class file with the given content.
struct File
{
    explicit File(const QByteArray& bytes)
    {
        QFile file(path());
        if (file.open(QIODevice::WriteOnly))
            file.write(bytes);
    }
    QString path() const { return folder.filePath(QStringLiteral("5b.ini")); }
    QString problem() const
    {
        try {
            ClassFile::read(path());
        } catch (const ClassFileError& error) {
            return error.sentence;
        }
        return {};
    }

    QTemporaryDir folder;
};
} // namespace

/// Tests that each class file of a teacher is either read completely, or refused with file, line and reason.
class TestClassFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyKeyIsRead()
    {
        const File file(whole());
        const ui::Classroom read = ClassFile::read(file.path());
        QCOMPARE(read.title, QStringLiteral("Klasse 5b, Ton & Töne"));
        QCOMPARE(read.folder, file.folder.filePath(QStringLiteral("works")));
        QCOMPARE(read.starters, QList({core::Starter::Vase, core::Starter::Ball}));
        QCOMPARE(read.tools, QList({core::Tool::Smooth, core::Tool::Pull}));
        QCOMPARE(read.turnMinutes, 30);
        QCOMPARE(read.warningMinutes, 5);
        QVERIFY(!read.fullScreen);
        QCOMPARE(read.language, ui::Language::German);
        QVERIFY(read.asksQuestions);
        QVERIFY(read.names.isEmpty() && read.allowsOthers);
    }

    void namesAreRead()
    {
        const File file(whole() + "names = Anna;  Müller,  Ben ;;小明\nother_names = no\n");
        const ui::Classroom read = ClassFile::read(file.path());
        QCOMPARE(read.names, QStringList({"Anna", "Müller, Ben", "小明"}));
        QVERIFY(!read.allowsOthers);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("again.fettleclass"));
        QCOMPARE(ClassFile::write(path, read), QString());
        QCOMPARE(ClassFile::read(path), read);
        QVERIFY(File(whole() + "names = Anna; Anna\n").problem().contains(QStringLiteral("names: Anna appears twice")));
        QVERIFY(File(whole() + "other_names = no\n").problem().contains(QStringLiteral("no names to choose from")));
        QVERIFY(File(whole() + "names = " + QByteArray(41, 'x') + '\n').problem().contains(QStringLiteral("at most")));
        QByteArray tooMany = "names = ";
        for (int i = 0; i <= ui::maxPupilNames; ++i)
            tooMany += QByteArray::number(i) + ';';
        QVERIFY(File(whole() + tooMany).problem().contains(QStringLiteral("line 13: names: at most 200 names")));
    }

    void whatIsWrittenIsReadAgain()
    {
        const QTemporaryDir folder;
        for (int turn : {0, 1, 240}) {
            const ui::Classroom written{QStringLiteral("a = b # c"),
                                        folder.filePath(QStringLiteral("Ä, b; %20 \"x\"")),
                                        {core::Starter::Torus},
                                        {core::Tool::SnakeHook},
                                        turn,
                                        turn / 2,
                                        turn == 0,
                                        ui::Language::Chinese,
                                        pinRecord(QStringLiteral("0815")),
                                        turn == 1};
            const QString path = folder.filePath(QStringLiteral("class.ini"));
            QCOMPARE(ClassFile::write(path, written), QString());
            QCOMPARE(ClassFile::read(path), written);
        }
    }

    /// A class file refers to a bundled lesson by name and to another lesson by a relative path. With a lesson,
    /// starters are optional.
    void theLessonIsRead()
    {
        const QByteArray tools =
            QByteArray(whole()).replace("smooth, pull", "smooth, pull, push, flatten, snake, inflate");
        const ui::Classroom beside = ClassFile::read(File(tools + "lesson = mug\n").path());
        QCOMPARE(beside.lesson, QStringLiteral("mug"));
        QCOMPARE(beside.starters.size(), 2);
        const File file(QByteArray(tools).replace("starters = vase, ball\n", "lesson = own/lesson.zip\n"));
        core::writeLesson(toPath(file.folder.filePath(QStringLiteral("lesson.zip"))),
                          readLesson(QStringLiteral("creature")));
        QVERIFY(QDir(file.folder.path()).mkdir(QStringLiteral("own")));
        QVERIFY(QFile::rename(file.folder.filePath(QStringLiteral("lesson.zip")),
                              file.folder.filePath(QStringLiteral("own/lesson.zip"))));
        const ui::Classroom alone = ClassFile::read(file.path());
        QCOMPARE(alone.lesson, file.folder.filePath(QStringLiteral("own/lesson.zip")));
        QVERIFY(alone.starters.isEmpty());
        const QString again = file.folder.filePath(QStringLiteral("again.fettleclass"));
        for (const ui::Classroom& written : {beside, alone}) {
            QCOMPARE(ClassFile::write(again, written), QString());
            QCOMPARE(ClassFile::read(again), written);
        }
    }

    void aBrokenLessonIsRefused()
    {
        const File file(whole() + "lesson = broken.zip\n");
        QFile broken(file.folder.filePath(QStringLiteral("broken.zip")));
        QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("PK no zip") > 0);
        broken.close();
        QVERIFY2(file.problem().contains(QStringLiteral("line 13: lesson: ")) &&
                     file.problem().contains(QStringLiteral("broken.zip")),
                 qPrintable(file.problem()));
    }

    void otherKeysHaveDefaults()
    {
        const File file("title=t\nfolder=/f\nstarters=ball\ntools=pull\r\n" + pinLine);
        const ui::Classroom read = ClassFile::read(file.path()), usual;
        QCOMPARE(read.turnMinutes, usual.turnMinutes);
        QCOMPARE(read.warningMinutes, usual.warningMinutes);
        QCOMPARE(read.fullScreen, usual.fullScreen);
        QCOMPARE(read.language, usual.language);
        QVERIFY(!read.asksQuestions);
    }

    void faultsAreNamed_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, const char* before, const char* after, const char* reason) {
            QTest::newRow(name) << QByteArray(before) << QByteArray(after) << QString::fromUtf8(reason);
        };
        row("unknown key", "full_screen", "fullscreen", "line 9: fullscreen is not a key of a class file.");
        row("no pair", "tools = smooth, pull", "tools", "line 6: each line must be key = value, or begin with #.");
        row("twice", "language = de", "title = x", "line 10: title appears twice.");
        row("no title", "title = Klasse 5b, Ton & Töne", "title =", "line 3: title: it is empty.");
        row("no number", "= 30", "= thirty",
            "line 7: turn_minutes: must be a whole number from 0 to 240, not \"thirty\".");
        row("too long", "= 30", "= 241", "line 7: turn_minutes: must be a whole number from 0 to 240, not \"241\".");
        row("negative", "=5", "=-1", "line 8: warning_minutes: must be a whole number from 0 to 30, not \"-1\".");
        row("warning before the turn", "=5", "=31",
            "line 8: warning_minutes: must be a whole number from 0 to 30, not \"31\".");
        row("unknown tool", "smooth, pull", "smooth, melt", "line 6: tools: \"melt\" is none of pull, push, inflate");
        row("tool twice", "smooth, pull", "pull,pull", "line 6: tools: pull appears twice.");
        row("empty in a list", "vase, ball", "vase,,ball",
            "line 5: starters: \"\" is none of ball, cube, torus, slab, vase, head, tablet.");
        row("neither yes nor no", "= no", "= maybe", "line 9: full_screen: \"maybe\" is none of yes, no.");
        row("questions", "questions = yes", "questions = 6", "line 11: questions: \"6\" is none of no, yes.");
        row("language", "= de", "= fr", "line 10: language: \"fr\" is none of system, en, de, zh_CN.");
        row("a PIN that can be read", pinLine.constData(), "pin = 1234\n",
            "line 12: pin: this is not a PIN as Fettle writes it");
        row("unknown lesson", "questions = yes", "lesson = mugs",
            "mugs is not a lesson: it is neither one of first-clay, mug, creature, toy-car nor a folder or ZIP file.");
        row("unknown lesson's line", "questions = yes", "lesson = mugs", "line 11: lesson: ");
        row("empty lesson", "questions = yes", "lesson =", "line 11: lesson: it is empty.");
        row("lesson with other tools", "questions = yes", "lesson = mug",
            "line 11: lesson: Step 1 of the lesson needs the tool Push (push), which is not among the class's tools.");
        row("neither starters nor lesson", "starters = vase, ball\n", "", "5b.ini: starters is missing.");
        row("no PIN", pinLine.constData(), "", "5b.ini: pin is missing.");
        row("no folder", "folder = works\n", "", "5b.ini: folder is missing.");
        row("not UTF-8", "Klasse", "\xff\xfe", "5b.ini is not a class file: it is not UTF-8 text, or it is too long.");
    }

    void faultsAreNamed()
    {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        QFETCH(QString, reason);
        QVERIFY(whole().contains(before));
        const File file(whole().replace(before, after));
        QVERIFY2(file.problem().startsWith(file.path()) && file.problem().contains(reason), qPrintable(file.problem()));
    }

    void strangersFilesAreRefused()
    {
        QVERIFY(File(QByteArray(70'000, '#')).problem().contains(QStringLiteral("too long")));
        QVERIFY(File(QByteArray(100, '\0')).problem().contains(QStringLiteral("not a class file")));
        QVERIFY(File({}).problem().contains(QStringLiteral("title is missing")));
        const QTemporaryDir folder;
        try {
            ClassFile::read(folder.filePath(QStringLiteral("none.ini")));
            QFAIL("a file that is not there was read");
        } catch (const ClassFileError& error) {
            QVERIFY2(error.sentence.contains(QStringLiteral("none.ini cannot be read (")), qPrintable(error.sentence));
        }
    }

    void aPinIsKnownByItsRecordOnly()
    {
        const QString pin = QStringLiteral("47 11ß"), one = pinRecord(pin), other = pinRecord(pin);
        QVERIFY(one != other && !one.contains(pin));
        QVERIFY(isPinRecord(one) && isPin(pin, one) && isPin(pin, other));
        QVERIFY(!isPin(QStringLiteral("47 11"), one) && !isPin({}, one));
        for (const QString& broken : {QString(), one + u'0', one.chopped(1),
                                      QString(one).replace(QStringLiteral("sha256"), QStringLiteral("md5")),
                                      QString(one).replace(QStringLiteral("100000"), QStringLiteral("0"))})
            QVERIFY2(!isPinRecord(broken) && !isPin(pin, broken), qPrintable(broken));
    }

    void aFileThatCannotBeWrittenSaysWhy()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("none/class.ini"));
        QVERIFY(ClassFile::write(path, {}).contains(QStringLiteral("does not exist")));
        QVERIFY(!QFile::exists(path));
    }
};

FETTLE_TEST(TestClassFile)
#include "tst_class_file.moc"
