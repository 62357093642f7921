#include "app/commands/word_guess.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace app
{
namespace
{
/// Counts typing errors: wrong, surplus and missing letters. Two swapped letters count as one error.
int typingErrors(const QString& typed, const QString& meant)
{
    const qsizetype n = meant.size();
    std::vector<int> before, row(static_cast<std::size_t>(n + 1)), next(row.size());
    std::iota(row.begin(), row.end(), 0);
    for (qsizetype i = 0; i < typed.size(); ++i) {
        next[0] = static_cast<int>(i) + 1;
        for (qsizetype j = 0; j < n; ++j) {
            const auto at = static_cast<std::size_t>(j);
            next[at + 1] = std::min({row[at] + (typed[i] == meant[j] ? 0 : 1), row[at + 1] + 1, next[at] + 1});
            if (i > 0 && j > 0 && typed[i] == meant[j - 1] && typed[i - 1] == meant[j])
                next[at + 1] = std::min(next[at + 1], before[at - 1] + 1);
        }
        before = std::exchange(row, next);
    }
    return row.back();
}
} // namespace

QString meantWord(const QString& typed, const QStringList& words)
{
    const auto bare = [](const QString& word) { return word.toLower().remove(u'-'); };
    const int most = bare(typed).size() < 5 ? 1 : 2;
    QString best;
    int fewest = most + 1;
    for (const QString& word : words)
        if (const int errors = typingErrors(bare(typed), bare(word)); errors < fewest) {
            fewest = errors;
            best = word;
        }
    return best;
}
} // namespace app
