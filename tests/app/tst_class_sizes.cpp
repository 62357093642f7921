// Checks the sizes of classes and functions. Those over the limits are listed in class_sizes.txt with a reason. Listed
// sizes are exact, so the table must be updated when a class shrinks.
// The following command writes the table again and keeps known reasons:
//     FETTLE_WRITE_SIZES=1 ctest --test-dir build/release -R TestClassSizes
#include "tests/app/source_outline.h"
#include "tests/support/test_main.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QTest>

namespace
{
constexpr int maxPublic = 15;
constexpr int maxPrivate = 12;
constexpr int maxLines = 60;

const QString tableFile = QStringLiteral(FETTLE_SOURCE_DIR "/tests/app/class_sizes.txt");

/// First lines of the table.
const char* const tableHead = "# Classes of more than 15 public or 12 private functions, and functions of more than 60 "
                              "lines: name | size | reason.\n"
                              "# tst_class_sizes compares this with the sources, and writes it.\n";

QByteArray contents(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList sources()
{
    QStringList files;
    for (const char* library : {"core", "ui", "vr", "app"}) {
        QDirIterator it(QStringLiteral(FETTLE_SOURCE_DIR "/") + library, {"*.h", "*.cpp"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext())
            files << it.next();
    }
    return files;
}

/// Returns "name | size" of each class and function over the limits.
QStringList largeParts(const SourceOutline& outline)
{
    QStringList found;
    for (const ClassOutline& part : outline.classes) {
        if (part.publicFunctions > maxPublic || part.privateFunctions > maxPrivate)
            found << QString("%1 | %2 public, %3 private")
                         .arg(QString::fromStdString(part.name))
                         .arg(part.publicFunctions)
                         .arg(part.privateFunctions);
    }
    for (const FunctionOutline& part : outline.functions) {
        if (part.lines > maxLines)
            found << QString("%1 | %2 lines").arg(QString::fromStdString(part.name)).arg(part.lines);
    }
    return found;
}

QStringList largePartsOfProgram()
{
    QStringList found;
    for (const QString& file : sources())
        found << largeParts(outlineOf(contents(file).toStdString()));
    found.sort();
    return found;
}

struct Row
{
    QString part; ///< "name | size" as in the table
    QString reason;

    QString name() const { return part.section(" | ", 0, 0); }
};

QList<Row> rowsOf(const QString& table)
{
    QList<Row> rows;
    for (const QString& line : table.split('\n', Qt::SkipEmptyParts)) {
        if (!line.startsWith('#'))
            rows << Row{line.section(" | ", 0, 1), line.section(" | ", 2)};
    }
    return rows;
}

/// Returns the errors of a table, or an empty list.
QStringList faults(const QList<Row>& rows, const QStringList& large)
{
    QStringList listed, found;
    for (const Row& row : rows) {
        listed << row.part;
        if (row.reason.isEmpty())
            found << "no reason is given: " + row.part;
        if (!large.contains(row.part))
            found << "no longer so: " + row.part;
    }
    for (const QString& part : large) {
        if (!listed.contains(part))
            found << "over the limit: " + part;
    }
    return found;
}

/// Returns the table with the reasons of the old one. New entries have no reason.
QString tableOf(const QStringList& large, const QList<Row>& old)
{
    QMap<QString, QString> reasons;
    for (const Row& row : old)
        reasons[row.name()] = row.reason;
    QString table = tableHead;
    for (const QString& part : large)
        table += part + " | " + reasons.value(Row{part, {}}.name()) + '\n';
    return table;
}

/// A source with one class, and the expected outline.
struct Example
{
    const char* name;
    const char* source;
    const char* outline; ///< expected result: "name public private"
};

const Example examples[] = {
    {"empty", "class A {};", "A 0 0"},
    {"private by default", "class A { void f(); };", "A 0 1"},
    {"public by default", "struct A { void f(); };", "A 1 0"},
    {"sections", "class A { public: int f(); private: int g(); protected: int h(); };", "A 1 2"},
    {"signals and slots", "class A { Q_OBJECT\npublic Q_SLOTS: void f(); Q_SIGNALS: void g(); };", "A 2 0"},
    {"namespace", "namespace a::b { namespace { class C final : public D<E> { void f(); }; } }", "a::b::C 0 1"},
    {"member elsewhere", "namespace a { struct B::C { void f(); }; }", "a::B::C 1 0"},
    {"members of data", "struct A { int a = f(), b{g()}; int c[3]; std::function<void(int)> d; };", "A 0 0"},
    {"pointers to functions", "struct A { void (*f)(int); void (A::*g)(); };", "A 0 0"},
    {"constructors", "struct A { explicit A(int a) : m_a(a), m_b{a} {} ~A(); int m_a, m_b; };", "A 2 0"},
    {"defaulted and deleted", "struct A { A() = default; A(const A&) = delete; virtual void f() = 0; };", "A 1 0"},
    {"friends, types, assertions", "struct A { friend void f(); using B = int (*)(int); static_assert(x(1)); };",
     "A 0 0"},
    {"enumerations", "struct A { enum class B : int { C = f(1), D }; B b() const; };", "A 1 0"},
    {"forward declarations", "class B; struct A { class C* f(); struct D; std::unique_ptr<D> d; };", "A 1 0"},
    {"operators", "struct A { bool operator<(A) const; int operator()(); operator bool() const { return f(); } };",
     "A 3 0"},
    {"templates", "template <class T, int n = (1 > 0)> struct A { template <class U> void f(U u); };", "A 1 0"},
    {"attributes", "struct [[nodiscard]] A { [[nodiscard]] int f() const noexcept(true); };", "A 1 0"},
    {"properties", "class A { Q_PROPERTY(int a READ a) Q_DISABLE_COPY(A)\npublic: int a() const { return m; } };",
     "A 1 0"},
    {"default arguments", "struct A { void f(B b = {}, int c = g()); };", "A 1 0"},
    {"comments and literals",
     "struct A { /* void f(); */ char c = '}'; // void g();\n const char* s = \"void h();{\"; };", "A 0 0"},
    {"raw strings, numbers", "struct A { const char* s = R\"x(\"}{)x\"; int i = 1'000; void f(); };", "A 1 0"},
    {"preprocessor", "#define X struct B { \\\n void f()\nstruct A { void f(); };", "A 1 0"},
    {"bodies", "struct A { int f() { struct { int g() { return 1; } } s; return s.g(); } int h(); };", "A 2 0"},
};
} // namespace

class TestClassSizes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void scan_countsFunctions_data();
    void scan_countsFunctions();
    void scan_namesNestedClasses();
    void scan_measuresFunctions();
    void scan_noticesMissingBraces();
    void limits_areInclusive();
    void table_isExact();
    void table_keepsReasons();
    void sources_areReadToTheEnd();
    void sources_keepTheLimits();
};

void TestClassSizes::scan_countsFunctions_data()
{
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("expected");
    for (const Example& example : examples)
        QTest::newRow(example.name) << QString(example.source) << QString(example.outline);
}

void TestClassSizes::scan_countsFunctions()
{
    QFETCH(QString, source);
    QFETCH(QString, expected);
    const SourceOutline outline = outlineOf(source.toStdString());
    QVERIFY(outline.isBalanced);
    QCOMPARE(outline.classes.size(), std::size_t(1));
    const ClassOutline& found = outline.classes.front();
    QCOMPARE(QString("%1 %2 %3")
                 .arg(QString::fromStdString(found.name))
                 .arg(found.publicFunctions)
                 .arg(found.privateFunctions),
             expected);
}

void TestClassSizes::scan_namesNestedClasses()
{
    const SourceOutline outline = outlineOf("namespace a { class B { struct C { void f(); } m_c; void g(); }; }");
    QCOMPARE(outline.classes.size(), std::size_t(2));
    QCOMPARE(outline.classes[0].name, std::string("a::B::C"));
    QCOMPARE(outline.classes[0].publicFunctions, 1);
    QCOMPARE(outline.classes[1].name, std::string("a::B"));
    QCOMPARE(outline.classes[1].privateFunctions, 1);
}

void TestClassSizes::scan_measuresFunctions()
{
    const SourceOutline outline = outlineOf("namespace a {\n"
                                            "B::B(int c)\n"
                                            "    : m_c{c}\n"
                                            "{\n"
                                            "    d([] { return 1; });\n"
                                            "}\n"
                                            "template <class T>\n"
                                            "auto e() -> std::vector<T>\n"
                                            "{}\n"
                                            "const int f[] = {1, 2};\n"
                                            "}\n");
    QCOMPARE(outline.functions.size(), std::size_t(2));
    QCOMPARE(outline.functions[0].name, std::string("a::B::B"));
    QCOMPARE(outline.functions[0].line, 2);
    QCOMPARE(outline.functions[0].lines, 5);
    QCOMPARE(outline.functions[1].name, std::string("a::e"));
    QCOMPARE(outline.functions[1].lines, 3);
}

void TestClassSizes::scan_noticesMissingBraces()
{
    QVERIFY(!outlineOf("struct A { void f();").isBalanced);
    QVERIFY(!outlineOf("void f() { if (a) { }").isBalanced);
    QVERIFY(!outlineOf("namespace a { } }").isBalanced);
}

void TestClassSizes::limits_areInclusive()
{
    SourceOutline outline;
    outline.classes = {{"A", 1, maxPublic, maxPrivate}};
    outline.functions = {{"f", 1, maxLines}};
    QCOMPARE(largeParts(outline), QStringList());
    outline.classes = {{"A", 1, maxPublic + 1, 0}, {"B", 1, 0, maxPrivate + 1}};
    outline.functions = {{"f", 1, maxLines + 1}};
    QCOMPARE(largeParts(outline),
             QStringList({"A | 16 public, 0 private", "B | 0 public, 13 private", "f | 61 lines"}));
}

void TestClassSizes::table_isExact()
{
    const QList<Row> rows = rowsOf("# a comment\nA | 20 public, 0 private | a gate\nf | 61 lines | \n");
    QCOMPARE(faults(rows.first(1), {"A | 20 public, 0 private"}), QStringList());
    QCOMPARE(faults(rows, {"A | 20 public, 0 private", "f | 61 lines"}),
             QStringList("no reason is given: f | 61 lines"));
    QCOMPARE(faults(rows.first(1), {"A | 19 public, 0 private"}),
             QStringList({"no longer so: A | 20 public, 0 private", "over the limit: A | 19 public, 0 private"}));
    QCOMPARE(faults(rows.first(1), {}), QStringList("no longer so: A | 20 public, 0 private"));
}

void TestClassSizes::table_keepsReasons()
{
    const QList<Row> old = rowsOf("A | 20 public, 0 private | a gate\nB | 16 public, 0 private | gone\n");
    QCOMPARE(tableOf({"A | 19 public, 0 private", "f | 61 lines"}, old),
             tableHead + QString("A | 19 public, 0 private | a gate\nf | 61 lines | \n"));
}

void TestClassSizes::sources_areReadToTheEnd()
{
    const QStringList files = sources();
    QVERIFY(!files.isEmpty());
    for (const QString& file : files)
        QVERIFY2(outlineOf(contents(file).toStdString()).isBalanced, qPrintable(file));
}

void TestClassSizes::sources_keepTheLimits()
{
    const QStringList large = largePartsOfProgram();
    if (qEnvironmentVariableIsSet("FETTLE_WRITE_SIZES")) {
        const QByteArray table = tableOf(large, rowsOf(contents(tableFile))).toUtf8();
        QFile file(tableFile);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(table) == table.size());
    }
    const QStringList found = faults(rowsOf(contents(tableFile)), large);
    QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
}

FETTLE_TEST(TestClassSizes, QCoreApplication)
#include "tst_class_sizes.moc"
