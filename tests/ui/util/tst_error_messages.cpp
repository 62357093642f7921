#include "ui/util/error_messages.h"

#include "core/analysis/mesh_check.h"
#include "core/io/mesh_io.h"
#include "tests/support/test_main.h"

#include <QSet>
#include <QTest>

#include <cerrno>

using core::FileError;
using core::FileErrorKind;

namespace
{
const std::filesystem::path path = std::filesystem::path("models") / "Löwe.stl";

FileError error(FileErrorKind kind)
{
    FileError e(kind, path);
    e.token = "tok";
    e.expected = 1234;
    e.found = 77;
    return e;
}

void verifySentence(const QString& words)
{
    QVERIFY2(words.endsWith(QLatin1Char('.')), qPrintable(words));
    QVERIFY2(!words.contains(QLatin1Char('%')) && !words.contains(QLatin1Char('<')), qPrintable(words));
    QVERIFY2(!words.contains(QLatin1Char('\n')), qPrintable(words));
}
} // namespace

class TestErrorMessages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyKindHasWordsOfItsOwn()
    {
        QSet<QString> seen;
        for (int k = 0; k <= static_cast<int>(FileErrorKind::WriteFailed); ++k) {
            const QString words = ui::ErrorMessages::sentence(error(static_cast<FileErrorKind>(k)));
            verifySentence(words);
            QVERIFY2(words.contains(QStringLiteral("Löwe.stl")), qPrintable(words));
            QVERIFY2(!words.contains(QStringLiteral("cannot be used.")), qPrintable(words));
            QVERIFY2(!seen.contains(words), qPrintable(words));
            seen << words;
        }
    }

    void remarks_nameParts()
    {
        core::ReadRemarks remarks{.negativeParts = 5, .otherParts = 1};
        const auto words = [&remarks] { return ui::ErrorMessages::remarks(QStringLiteral("a.3mf"), remarks); };
        QVERIFY(words().contains(QStringLiteral("cut out of the model (5), modifiers and supports of a slicer (1).")));
        remarks.negativeNames = {"50%1", "Peg", "Slot"};
        remarks.otherNames = {"Löwe"};
        QVERIFY(words().contains(QStringLiteral("(\"50%1\", \"Peg\", \"Slot\" and 2 more)")));
        QVERIFY(words().endsWith(QStringLiteral(" (\"Löwe\").")));
        remarks.announcedTriangles = 13;
        remarks.containedTriangles = 12;
        QVERIFY(words().endsWith(QStringLiteral("; it announces 13 triangles and contains 12.")));
    }

    /// Each fault has its own sentence, with file and line.
    void everyFaultHasWordsOfItsOwn()
    {
        QSet<QString> seen;
        for (int k = 0; k <= static_cast<int>(core::FileFault::XmlLongTag); ++k)
            for (const char* found : {"tok", ""}) {
                FileError e(FileErrorKind::Malformed, path);
                e.fault = static_cast<core::FileFault>(k);
                e.token = found;
                e.wanted = "outer";
                e.place = {core::FilePlace::Unit::Line, 12};
                const QString words = ui::ErrorMessages::sentence(e);
                verifySentence(words);
                QVERIFY2(words.contains(QStringLiteral("Löwe.stl")), qPrintable(words));
                QVERIFY2(words.contains(QStringLiteral("line 12")), qPrintable(words));
                QVERIFY2(!words.contains(QStringLiteral("understood")), qPrintable(words));
                if (*found != 0)
                    QVERIFY2(!seen.contains(words), qPrintable(words));
                seen << words;
            }
        FileError e(FileErrorKind::Malformed, path);
        e.fault = core::FileFault::Keyword;
        e.wanted = "outer";
        e.token = "lop";
        QVERIFY(ui::ErrorMessages::sentence(e).endsWith(QStringLiteral(": expected \"outer\", found \"lop\".")));
    }

    void missingDataLeavesWholeSentences()
    {
        for (int k = 0; k <= static_cast<int>(FileErrorKind::WriteFailed); ++k)
            verifySentence(ui::ErrorMessages::sentence(FileError(static_cast<FileErrorKind>(k), path)));
    }

    void thePlaceIsNamed()
    {
        FileError e = error(FileErrorKind::NotANumber);
        e.place = {core::FilePlace::Unit::Line, 42};
        QVERIFY(ui::ErrorMessages::sentence(e).contains(QStringLiteral("line 42: \"tok\"")));
        e.place = {core::FilePlace::Unit::Byte, 80};
        QVERIFY(ui::ErrorMessages::sentence(e).contains(QStringLiteral("byte 80:")));
    }

    /// A valid number may still be wrong at its place in the file, and the message says why.
    void numbersAreCalledWhatTheyAre()
    {
        FileError e(FileErrorKind::NotANumber, path);
        e.place = {core::FilePlace::Unit::Line, 2};
        for (const auto& [token, words] : {std::pair{"4.0", "\"4.0\" is not a whole number that is valid here."},
                                           {"-1", "\"-1\" is not a whole number that is valid here."},
                                           {"4294967296", "\"4294967296\" is not a whole number that is valid here."},
                                           {"nan", "\"nan\" is not a finite number."},
                                           {"1e39", "\"1e39\" is not a finite number."},
                                           {"1e999", "\"1e999\" is not a finite number."},
                                           {"0,5", "\"0,5\" is not a finite number."},
                                           {"", "a number is missing here, or is not finite."}}) {
            e.token = token;
            QVERIFY2(ui::ErrorMessages::sentence(e).endsWith(QLatin1StringView(words)), token);
        }
        e.place = {core::FilePlace::Unit::Byte, 2};
        QVERIFY(ui::ErrorMessages::sentence(e).endsWith(QStringLiteral("a coordinate is not a finite number.")));
        FileError none(FileErrorKind::NoFaces, path);
        QVERIFY(ui::ErrorMessages::sentence(none).endsWith(QStringLiteral(" contains no faces.")));
        none.expected = 3;
        QVERIFY(ui::ErrorMessages::sentence(none).contains(QStringLiteral("slicer parts that are not printed (3)")));
    }

    void announcedElementsAreTold()
    {
        for (const auto& [kind, elements, words] :
             {std::tuple{FileErrorKind::CutOff, "faces", "incomplete; 24 faces are announced, but it has room for 12."},
              {FileErrorKind::CutOff, "vertices", "incomplete; 24 vertices are announced, but it has room for 12."},
              {FileErrorKind::CountMismatch, "faces", "24 faces are announced, but the file has 12."},
              {FileErrorKind::CountMismatch, "", "24 elements are announced, but the file has room for 12."}}) {
            FileError e(kind, path);
            e.token = elements;
            e.expected = 24;
            e.found = 12;
            QVERIFY2(ui::ErrorMessages::sentence(e).endsWith(QLatin1StringView(words)), words);
        }
    }

    void theSystemsReasonIsGiven()
    {
        FileError e = error(FileErrorKind::NotWritable);
        e.systemError = EACCES;
        QVERIFY(ui::ErrorMessages::sentence(e).contains(qt_error_string(EACCES)));
    }

    /// A % sign in the file's content is not mistaken for a parameter of the message.
    void aPercentSignInTheFileIsHarmless()
    {
        FileError e = error(FileErrorKind::IndexOutOfRange);
        e.token = "%1%2%3";
        QVERIFY(ui::ErrorMessages::sentence(e).contains(QStringLiteral("vertex %1%2%3, but there are only 1,234")) ||
                ui::ErrorMessages::sentence(e).contains(QStringLiteral("vertex %1%2%3, but there are only 1234")));
        FileError odd(FileErrorKind::CutOff, "100%1.stl");
        odd.expected = 10;
        QVERIFY(ui::ErrorMessages::sentence(odd).contains(QStringLiteral("100%1.stl")));
    }

    void aRefusalCountsEachFault()
    {
        core::MeshReport report;
        report.openEdges.count = 12;
        report.intersections.count = 3;
        const QString words = ui::ErrorMessages::refusal(QStringLiteral("cup.obj"), report);
        verifySentence(words);
        QVERIFY(words.startsWith(QStringLiteral("cup.obj cannot be sculpted yet")));
        QVERIFY(words.contains(QStringLiteral("open edges: 12")));
        QVERIFY(words.contains(QStringLiteral("intersect: 3")));
        QVERIFY(!words.contains(QStringLiteral(": 0")));
    }

    void everyShortfallHasWordsOfItsOwn()
    {
        QSet<QString> seen;
        for (int k = 1; k <= static_cast<int>(core::Shortfall::Masked); ++k) {
            const QString words = ui::ErrorMessages::shortfall(static_cast<core::Shortfall>(k));
            verifySentence(words);
            QVERIFY2(!seen.contains(words), qPrintable(words));
            seen << words;
        }
        QVERIFY(ui::ErrorMessages::shortfall(core::Shortfall::None).isEmpty());
    }

    void aRangeHasItsBoundsAndUnit()
    {
        const QString radius = ui::ErrorMessages::range(core::Parameter::Radius, 0.27951, 50);
        verifySentence(radius);
        QVERIFY2(radius.contains(QStringLiteral("0.28")) && radius.contains(QStringLiteral("50 mm")),
                 qPrintable(radius));
        const QString strength = ui::ErrorMessages::range(core::Parameter::Strength, 0, 10);
        verifySentence(strength);
        QVERIFY2(strength.contains(QStringLiteral("10")) && !strength.contains(QStringLiteral("mm")),
                 qPrintable(strength));
    }

    void aRefusalWithoutCountsStillHasAReason()
    {
        const QString words = ui::ErrorMessages::refusal(QStringLiteral("cup.obj"), {});
        verifySentence(words);
        QVERIFY(words.contains(QStringLiteral("inside out")));
        verifySentence(ui::ErrorMessages::tooFine(QStringLiteral("cup.obj"), 5));
    }
};

FETTLE_TEST(TestErrorMessages)
#include "tst_error_messages.moc"
