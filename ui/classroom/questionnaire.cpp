#include "ui/classroom/questionnaire.h"

#include <QCoreApplication>

#include <algorithm>
#include <numeric>

namespace ui
{
namespace
{
struct QuestionText
{
    Q_DECLARE_TR_FUNCTIONS(ui::Questionnaire)
};
} // namespace

QuestionWords QuestionWords::of(Question question)
{
    switch (question) {
    case Question::Mastering:
        return {QuestionText::tr("How easy was it to learn to use the program?"),
                QuestionText::tr("extremely difficult"), QuestionText::tr("extremely easy")};
    case Question::Functions:
        return {QuestionText::tr("Was everything there that you needed?"), QuestionText::tr("incomplete"),
                QuestionText::tr("complete")};
    case Question::Errors:
        return {QuestionText::tr("How often did something go wrong while you sculpted?"),
                QuestionText::tr("extremely often"), QuestionText::tr("extremely rarely")};
    case Question::Details:
        return {QuestionText::tr("How convenient was it to make details?"), QuestionText::tr("very inconvenient"),
                QuestionText::tr("very convenient")};
    case Question::Topology:
        return {QuestionText::tr("How freely could you make holes and handles, and join parts?"),
                QuestionText::tr("not freely at all"), QuestionText::tr("completely freely")};
    case Question::Overall:
        return {QuestionText::tr("How do you find the program as a whole?"), QuestionText::tr("poor"),
                QuestionText::tr("good")};
    }
    Q_UNREACHABLE();
}

bool Questionnaire::isEmpty() const
{
    return std::ranges::none_of(answers, [](const std::optional<int>& answer) { return answer.has_value(); });
}

int AnswerSum::total() const
{
    return std::accumulate(counts.begin(), counts.end(), 0);
}

double AnswerSum::mean() const
{
    int points = 0, point = minAnswer;
    for (const int count : counts)
        points += count * point++;
    return total() == 0 ? 0 : static_cast<double>(points) / total();
}

std::array<AnswerSum, questionCount> sumsOf(const QList<Questionnaire>& questionnaires)
{
    std::array<AnswerSum, questionCount> sums;
    for (const Questionnaire& questionnaire : questionnaires)
        for (std::size_t i = 0; i < questionCount; ++i)
            if (const std::optional<int> answer = questionnaire.answers[i])
                ++sums[i].counts.at(static_cast<std::size_t>(*answer - minAnswer));
    return sums;
}
} // namespace ui
