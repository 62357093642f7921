#include "ui/widgets/file_dialogs.h"

#include "tests/ui/ui_test.h"

#include <QFile>
#include <QFileDialog>
#include <QFileIconProvider>
#include <QTemporaryDir>

class TestFileDialogs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// File types are recognised by name only, because reading a file that does not respond would block for ever.
    void kinds_areKnownByName()
    {
        const QTemporaryDir folder;
        const auto write = [&](const char* name) {
            QFile file(folder.filePath(QLatin1StringView(name)));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write("%PDF-1.4\n");
        };
        write("unnamed");
        write("named.pdf");
        QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("inner")));
        QWidget window;
        window.show();
        ui::askForModel(&window, ui::ModelUse::Open, folder.path(), [](const QString&) {});
        const auto* dialog = window.findChild<QFileDialog*>();
        QVERIFY(dialog);
        const QAbstractFileIconProvider* icons = dialog->iconProvider();
        const auto kindOf = [&](const char* name) {
            return icons->type(QFileInfo(folder.filePath(QLatin1StringView(name))));
        };
        QVERIFY(kindOf("named.pdf").contains(QStringLiteral("PDF")));
        QVERIFY(!kindOf("unnamed").contains(QStringLiteral("PDF")));
        QVERIFY(kindOf("inner") != kindOf("unnamed"));
        for (const char* name : {"named.pdf", "unnamed", "inner"})
            QVERIFY(!icons->icon(QFileInfo(folder.filePath(QLatin1StringView(name)))).isNull());
    }
};

FETTLE_TEST(TestFileDialogs, ui::TestApplication)
#include "tst_file_dialogs.moc"
