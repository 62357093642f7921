#include "ui/classroom/classroom.h"
#include "ui/classroom/names_field.h"

#include "tests/support/test_main.h"
#include "tests/ui/ui_test.h"

#include <QLabel>
#include <QPlainTextEdit>

/// Tests that no change to a teacher's list of names goes unreported.
class TestNamesField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_field = std::make_unique<ui::NamesField>();
        m_field->show();
    }
    void cleanup() { m_field.reset(); }

    void goodNames_needNoWord()
    {
        type(
            {QStringLiteral("  Anna  Maria "), QString(), QStringLiteral("Ben; B."), longName(ui::maxPupilNameLength)});
        QCOMPARE(m_field->names(), QStringList({"Anna Maria", "Ben B.", longName(ui::maxPupilNameLength)}));
        QCOMPARE(word(), QString());
        QCOMPARE(m_field->fault(), QString());
    }

    void aNameTwice_countsOnce()
    {
        type({QStringLiteral("Anna"), QStringLiteral("Ben"), QStringLiteral("Anna "), QStringLiteral("Anna")});
        QCOMPARE(m_field->names(), QStringList({"Anna", "Ben"}));
        QCOMPARE(word(), QStringLiteral("In the list more than once, and counted once: Anna."));
        QCOMPARE(m_field->fault(), QString());
        QStringList pairs;
        for (int i = 0; i < 20; ++i)
            pairs << QString::number(i / 2);
        type(pairs);
        QVERIFY(word().contains(QStringLiteral(": 0, 1, 2, 3, …")));
    }

    void aLongName_isRefused()
    {
        const QString name = longName(ui::maxPupilNameLength + 1);
        type({QStringLiteral("Anna"), name, QStringLiteral("Anna")});
        QVERIFY(m_field->fault().contains(name.chopped(1)) && m_field->fault().contains(QStringLiteral("40")));
        QCOMPARE(word(), m_field->fault());
        QVERIFY(m_field->names().contains(name)); // the long name is not shortened
    }

    void tooManyNames_areRefused()
    {
        QStringList names;
        for (int i = 0; i <= ui::maxPupilNames; ++i)
            names << QStringLiteral("Pupil %1").arg(i);
        type(names);
        QVERIFY(m_field->fault().contains(QStringLiteral("at most 200 names; these are 201")));
        QCOMPARE(word(), m_field->fault());
        QCOMPARE(m_field->names(), names);
        names.removeLast();
        m_field->setNames(names);
        QCOMPARE(word(), QString());
        QCOMPARE(m_field->names(), names);
    }

private:
    static QString longName(int length) { return QString(length, u'x'); }
    void type(const QStringList& lines)
    {
        m_field->findChild<QPlainTextEdit*>(QStringLiteral("classNames"))->setPlainText(lines.join(u'\n'));
    }
    /// Returns the visible remark below the field; empty if it is hidden.
    QString word() const
    {
        const auto* label = m_field->findChild<QLabel*>(QStringLiteral("classNamesWord"));
        return label->isVisible() ? label->text() : QString();
    }

    std::unique_ptr<ui::NamesField> m_field;
};

FETTLE_TEST(TestNamesField, ui::TestApplication)
#include "tst_names_field.moc"
