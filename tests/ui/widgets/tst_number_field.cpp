// Types numbers with either decimal mark, in several languages.

#include "ui/widgets/number_field.h"

#include "tests/support/test_main.h"

#include <QApplication>
#include <QLineEdit>
#include <QTest>

#include <utility>

namespace
{
struct Field : ui::NumberField
{
    explicit Field(const QLocale& locale)
    {
        setLocale(locale);
        setDecimals(4);
        setRange(-1e6, 1e6);
        setSuffix(QStringLiteral(" mm"));
        selectAll();
    }
    void paste(const QString& text)
    {
        lineEdit()->selectAll();
        lineEdit()->insert(text);
        interpretText();
    }
};
} // namespace

class TestNumberField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bothMarks_areTheDecimalMark_data() { addLanguages(); }
    void bothMarks_areTheDecimalMark();
    void separatorsOfThousands_areRefused_data() { addLanguages(); }
    void separatorsOfThousands_areRefused();

private:
    static void addLanguages()
    {
        QTest::addColumn<QLocale>("locale");
        for (const char* language : {"en", "de", "zh_CN", "fr", "de_CH"})
            QTest::newRow(language) << QLocale(QLatin1StringView(language));
    }
};

void TestNumberField::bothMarks_areTheDecimalMark()
{
    QFETCH(QLocale, locale);
    const std::pair<const char*, double> numbers[] = {{"1,5", 1.5},     {"1.5", 1.5},       {"-1,234", -1.234},
                                                      {"1.234", 1.234}, {"1234,5", 1234.5}, {",5", 0.5}};
    for (const auto& [text, value] : numbers) {
        Field typed(locale), pasted(locale);
        QTest::keyClicks(&typed, QLatin1StringView(text));
        QTest::keyClick(&typed, Qt::Key_Return);
        QCOMPARE(typed.value(), value);
        pasted.paste(QLatin1StringView(text));
        QCOMPARE(pasted.value(), value);
    }
}

/// A number with two marks, or with the separator of the language, is no number.
void TestNumberField::separatorsOfThousands_areRefused()
{
    QFETCH(QLocale, locale);
    QStringList refused{QStringLiteral("1,234.5"), QStringLiteral("1.234,5"), QStringLiteral("1.234.567")};
    if (const QString separator = locale.groupSeparator(); separator != u"." && separator != u",")
        refused << QStringLiteral("1") + separator + QStringLiteral("234");
    for (const QString& text : refused) {
        Field field(locale);
        field.setValue(7);
        field.paste(text);
        QCOMPARE(field.value(), 7.0);
    }
}

FETTLE_TEST(TestNumberField, QApplication)

#include "tst_number_field.moc"
