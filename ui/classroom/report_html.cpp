#include "ui/classroom/report_html.h"

#include "ui/classroom/class_report.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QLocale>

#include <optional>

namespace ui
{
namespace
{
constexpr int shownSide = 80; ///< CSS pixels

// CSS of the page. Its light and dark greens and reds are those of the Model panel.
constexpr char pageStyle[] = R"(
:root { color-scheme: light dark; }
:root { --ink: #1c1c1e; --faint: #5c5c63; --paper: #fff; --line: #d5d5da; --shade: #f3f3f6; --link: #0b57b8;
  --good: #1e7a3a; --bad: #b3261e; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #ececf0; --faint: #a9a9b3; --paper: #1f1f23; --line: #3d3d45; --shade: #2a2a30; --link: #8ab8ff;
    --good: #66cc88; --bad: #f28b82; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem; max-width: 76rem; color: var(--ink); background: var(--paper);
  font: 15px/1.4 system-ui, "Noto Sans", sans-serif; }
h1 { margin: 0; font-size: 1.5rem; overflow-wrap: anywhere; }
h2 { margin: 2rem 0 .5rem; font-size: 1.15rem; }
p { margin: .25rem 0 1.5rem; color: var(--faint); }
table { width: 100%; border-collapse: collapse; }
thead > tr > * { position: sticky; top: 0; background: var(--paper); box-shadow: inset 0 -2px var(--line);
  vertical-align: bottom; white-space: nowrap; }
th, td { padding: .4rem .5rem; text-align: left; vertical-align: middle; }
tbody tr { border-bottom: 1px solid var(--line); }
tbody tr:hover { background: var(--shade); }
tbody th { min-width: 8rem; font-weight: 600; overflow-wrap: anywhere; }
.figure { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
.questions .figure { width: 3.5rem; }
.picture { width: 6rem; }
img { display: block; }
a { color: var(--link); text-decoration: none; }
a:hover { text-decoration: underline; }
b { white-space: nowrap; font-weight: 600; }
small { display: block; min-width: 11rem; max-width: 22rem; color: var(--faint); font-size: .8rem;
  overflow-wrap: anywhere; }
th small { font-weight: 400; }
.ready b { color: var(--good); }
.not b { color: var(--bad); }
button { padding: 0; border: 0; background: none; color: inherit; font: inherit; cursor: pointer; }
button:hover, button:focus-visible { text-decoration: underline; }
[aria-sort=ascending] button::before { content: "▴ "; }
[aria-sort=descending] button::before { content: "▾ "; }
@media print {
  :root { --ink: #000; --faint: #444; --paper: #fff; --line: #aaa; --shade: #fff; --link: #000; --good: #1e7a3a;
    --bad: #b3261e; }
  @page { margin: 12mm; }
  body { padding: 0; max-width: none; font-size: 9.5pt; }
  thead > tr > * { position: static; }
  tr { break-inside: avoid; }
  .picture { width: 20mm; }
  img { width: 18mm; height: 18mm; }
}
)";

// Script of the page: buttons in the heads sort by that column, numbers by data-key, words in the language's order.
// Cells without data-key are sorted last.
constexpr char pageScript[] = R"(
const table = document.querySelector("table"), body = table.tBodies[0];
const order = new Intl.Collator(document.documentElement.lang, { numeric: true });
for (const head of table.querySelectorAll("thead th[data-sorts]")) {
  const button = document.createElement("button");
  button.append(...head.childNodes);
  head.append(button);
  button.addEventListener("click", () => {
    const turn = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
    const key = (row) => {
      const cell = row.cells[head.cellIndex];
      return head.dataset.sorts === "words" ? cell.textContent : cell.dataset.key;
    };
    const compare = (a, b) => (head.dataset.sorts === "words" ? order.compare(a, b) : a - b);
    const rows = [...body.rows].sort((a, b) => {
      const x = key(a), y = key(b);
      return x === undefined || y === undefined ? (x === undefined) - (y === undefined) : turn * compare(x, y);
    });
    for (const other of table.querySelectorAll("[aria-sort]")) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", turn > 0 ? "ascending" : "descending");
    body.append(...rows);
  });
}
)";

QString hashOf(const char* text)
{
    const QByteArray hash = QCryptographicHash::hash(text, QCryptographicHash::Sha256);
    return QStringLiteral("'sha256-%1'").arg(QLatin1StringView(hash.toBase64()));
}

QString escaped(const QString& text)
{
    return text.toHtmlEscaped();
}

QString pictureData(const QImage& picture)
{
    QBuffer png;
    png.open(QIODevice::WriteOnly);
    picture.save(&png, "PNG");
    return QStringLiteral("data:image/png;base64,") + QLatin1StringView(png.data().toBase64());
}

/// Returns the attribute data-key, by which the script sorts. nullopt: no attribute, so the row is sorted last in
/// either direction.
QString keyed(const std::optional<double>& key)
{
    constexpr int digits = 10; // significant digits
    return key ? QStringLiteral(" data-key=\"%1\"").arg(QString::number(*key, 'g', digits)) : QString();
}

QString figureCell(const std::optional<double>& key, const QString& text)
{
    return QStringLiteral("<td class=\"figure\"%1>%2</td>\n").arg(keyed(key), escaped(text));
}

std::optional<double> longestSide(const ReportRow& row)
{
    return row.report ? std::optional(row.report->size.maxCoeff()) : std::nullopt;
}

std::optional<double> volumeOf(const ReportRow& row)
{
    return row.report && row.report->volume ? std::optional(std::abs(*row.report->volume)) : std::nullopt;
}

QString verdictCell(const ReportCells& cells)
{
    const bool isReady = cells.verdict == ReportVerdict::Ready;
    const QString note =
        cells.note.isEmpty() ? QString() : QStringLiteral("<small>%1</small>").arg(escaped(cells.note));
    return QStringLiteral("<td class=\"%1\"%2><b>%3 %4</b>%5</td>\n")
        .arg(QLatin1StringView(isReady ? "ready" : "not"), keyed(static_cast<double>(cells.verdict)),
             QLatin1StringView(isReady ? "&#10003;" : "&#10007;"), escaped(cells.word), note);
}

QString rowText(const ReportRow& row, const std::filesystem::path& path)
{
    const ReportCells cells = cellsOf(row);
    const QString link = escaped(reportLink(path, row.file));
    const QString picture =
        row.picture.isNull() ? QString()
                             : QStringLiteral("<a href=\"%1\"><img width=\"%2\" height=\"%2\" alt=\"\" src=\"%3\"></a>")
                                   .arg(link, QString::number(shownSide), pictureData(row.picture));
    const std::optional<double> strokes =
        row.work ? std::optional(static_cast<double>(row.work->strokes)) : std::nullopt;
    const QString lesson =
        cells.lesson.isEmpty() ? QString() : QStringLiteral("<small>%1</small>").arg(escaped(cells.lesson));
    return QStringLiteral("<tr>\n<td class=\"picture\">%1</td>\n").arg(picture) +
           QStringLiteral("<th scope=\"row\"><a href=\"%1\"><bdi>%2</bdi></a>%3</th>\n")
               .arg(link, escaped(cells.name), lesson) +
           figureCell(longestSide(row), cells.size) + figureCell(volumeOf(row), cells.volume) + verdictCell(cells) +
           figureCell(row.seconds(), cells.time) + figureCell(strokes, cells.strokes) + QStringLiteral("</tr>\n");
}

QString headRow()
{
    constexpr const char *words = " data-sorts=\"words\" aria-sort=\"ascending\"", *kind = " data-sorts=\"numbers\"",
                         *figure = " class=\"figure\" data-sorts=\"numbers\"";
    const char* const kinds[] = {words, figure, figure, kind, figure, figure};
    QString text = QStringLiteral("<tr>\n<td class=\"picture\"></td>\n");
    const QStringList heads = reportHeads();
    for (qsizetype i = 0; i < heads.size(); ++i)
        text += QStringLiteral("<th scope=\"col\"%1>%2</th>\n").arg(QLatin1StringView(kinds[i]), escaped(heads[i]));
    return text + QStringLiteral("</tr>\n");
}

/// Returns the table of questions as HTML; empty if nobody answered.
QString questionTable(const ClassReport& report)
{
    const QList<QuestionCells> rows = questionCellsOf(report);
    if (rows.isEmpty())
        return {};
    QString text =
        QStringLiteral("<h2>%1</h2>\n<table class=\"questions\">\n<thead>\n<tr>\n").arg(escaped(questionsTitle()));
    QString kind;
    for (const QString& head : questionHeads()) {
        text += QStringLiteral("<th scope=\"col\"%1>%2</th>\n").arg(kind, escaped(head));
        kind = QStringLiteral(" class=\"figure\""); // all columns except the first
    }
    text += QStringLiteral("</tr>\n</thead>\n<tbody>\n");
    for (const QuestionCells& row : rows) {
        text += QStringLiteral("<tr>\n<th scope=\"row\">%1<small>%2</small></th>\n")
                    .arg(escaped(row.question), escaped(row.scale));
        text += figureCell({}, row.answers) + figureCell({}, row.mean);
        for (const QString& count : row.counts)
            text += figureCell({}, count);
        text += QStringLiteral("</tr>\n");
    }
    return text + QStringLiteral("</tbody>\n</table>\n");
}
} // namespace

QByteArray reportHtml(const ClassReport& report, const std::filesystem::path& path)
{
    const QString title = escaped(reportTitle(report));
    QByteArray page =
        QStringLiteral("<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
                       "style-src %2; script-src %3\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>%4</title>\n")
            .arg(QLocale().bcp47Name(), hashOf(pageStyle), hashOf(pageScript), title)
            .toUtf8();
    page += QByteArray("<style>") + pageStyle + "</style>\n</head>\n<body>\n";
    page += QStringLiteral("<h1>%1</h1>\n<p>%2</p>\n<table>\n<thead>\n%3</thead>\n<tbody>\n")
                .arg(title, escaped(reportSummary(report)), headRow())
                .toUtf8();
    for (const ReportRow& row : report.rows)
        page += rowText(row, path).toUtf8();
    page += "</tbody>\n</table>\n" + questionTable(report).toUtf8();
    page += QByteArray("<script>") + pageScript + "</script>\n</body>\n</html>\n";
    return page;
}
} // namespace ui
