#include "tests/app/source_outline.h"

#include <algorithm>
#include <cctype>

namespace
{
struct Token
{
    std::string text; ///< a word, an operator, "::", or "\"" for any literal
    int line = 0;
};

bool isWordCharacter(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool isWord(const Token& token)
{
    return isWordCharacter(token.text.front());
}

/// Splits a source into tokens, omitting comments, preprocessor lines and the contents of literals.
class Scanner
{
public:
    explicit Scanner(std::string_view source) : m_source(source) {}

    std::vector<Token> tokens()
    {
        while (m_at < m_source.size())
            next();
        return std::move(m_tokens);
    }

private:
    bool startsWith(std::string_view text) const { return m_source.substr(m_at).starts_with(text); }

    void advance(std::size_t count)
    {
        const std::size_t end = std::min(m_at + count, m_source.size());
        m_line += static_cast<int>(std::count(m_source.begin() + m_at, m_source.begin() + end, '\n'));
        m_at = end;
    }

    /// Moves past the next occurrence of `text`.
    void skipPast(std::string_view text, std::size_t from = 0)
    {
        const std::size_t found = m_source.find(text, m_at + from);
        advance(found == std::string_view::npos ? m_source.size() : found + text.size() - m_at);
    }

    void next()
    {
        const char c = m_source[m_at];
        if (c == '\n')
            m_isLineStart = true;
        if (std::isspace(static_cast<unsigned char>(c)))
            advance(1);
        else if (startsWith("//"))
            skipLine();
        else if (startsWith("/*"))
            skipPast("*/", 2);
        else if (c == '#' && m_isLineStart)
            skipLine();
        else
            readToken(c);
    }

    void skipLine()
    {
        while (m_at < m_source.size() && m_source[m_at] != '\n')
            advance(m_source[m_at] == '\\' ? 2 : 1);
    }

    void readToken(char c)
    {
        m_isLineStart = false;
        const int line = m_line;
        if (startsWith("R\"")) {
            const std::size_t open = m_source.find('(', m_at);
            skipPast(')' + std::string(m_source.substr(m_at + 2, open - m_at - 2)) + '"');
            m_tokens.push_back({"\"", line});
        } else if (c == '"' || c == '\'') {
            skipQuoted(c);
            m_tokens.push_back({"\"", line});
        } else {
            const std::size_t length = isWordCharacter(c) ? wordLength() : (startsWith("::") ? 2 : 1);
            m_tokens.push_back({std::string(m_source.substr(m_at, length)), line});
            advance(length);
        }
    }

    /// Returns the length of the word. Numbers may contain separators: 1'000.
    std::size_t wordLength() const
    {
        const bool isNumber = std::isdigit(static_cast<unsigned char>(m_source[m_at]));
        std::size_t length = 1;
        while (m_at + length < m_source.size() &&
               (isWordCharacter(m_source[m_at + length]) || (isNumber && m_source[m_at + length] == '\'')))
            ++length;
        return length;
    }

    void skipQuoted(char quote)
    {
        advance(1);
        while (m_at < m_source.size() && m_source[m_at] != quote)
            advance(m_source[m_at] == '\\' ? 2 : 1);
        advance(1);
    }

    std::string_view m_source;
    std::size_t m_at = 0;
    int m_line = 1;
    bool m_isLineStart = true;
    std::vector<Token> m_tokens;
};

/// Parses declarations in namespaces and classes, and skips the bodies of functions.
class Parser
{
public:
    explicit Parser(std::vector<Token> tokens) : m_tokens(std::move(tokens)) {}

    SourceOutline outline()
    {
        readScope({}, nullptr);
        m_outline.isBalanced = m_outline.isBalanced && m_at == m_tokens.size();
        return std::move(m_outline);
    }

private:
    bool is(std::string_view text, std::size_t ahead = 0) const
    {
        return m_at + ahead < m_tokens.size() && m_tokens[m_at + ahead].text == text;
    }

    bool take(std::string_view text)
    {
        if (!is(text))
            return false;
        ++m_at;
        return true;
    }

    /// Moves from an opening bracket past the matching closing one.
    void skipBalanced(std::string_view open, std::string_view close)
    {
        for (++m_at; m_at < m_tokens.size(); ++m_at) {
            if (take(close))
                return;
            if (is(open) ? (skipBalanced(open, close), true) : skipBrackets())
                --m_at;
        }
        m_outline.isBalanced = false;
    }

    bool skipBrackets()
    {
        if (is("("))
            skipBalanced("(", ")");
        else if (is("["))
            skipBalanced("[", "]");
        else if (is("{"))
            skipBalanced("{", "}");
        else
            return false;
        return true;
    }

    void skipStatement()
    {
        while (m_at < m_tokens.size() && !is(";") && !is("}"))
            if (!skipBrackets())
                ++m_at;
        take(";");
    }

    /// Reads declarations up to the closing brace of the scope. `members`: outline of the class, null in a namespace.
    void readScope(const std::string& scope, ClassOutline* members, bool isPublic = true)
    {
        while (m_at < m_tokens.size() && !is("}")) {
            if (members && readAccess(isPublic))
                continue;
            readDeclaration(scope, members, isPublic);
        }
    }

    bool readAccess(bool& isPublic)
    {
        const bool isSection = is("public") || is("private") || is("protected") || is("Q_SIGNALS") || is("signals");
        if (!isSection)
            return false;
        isPublic = !is("private") && !is("protected");
        while (!take(":"))
            ++m_at;
        return true;
    }

    void readDeclaration(const std::string& scope, ClassOutline* members, bool isPublic)
    {
        if (take(";") || skipMacro())
            return;
        m_line = m_tokens[m_at].line;
        while (is("template") || is("[")) {
            take("template");
            if (is("<"))
                skipBalanced("<", ">");
            else if (is("["))
                skipBrackets();
        }
        if (is("namespace") || (is("inline") && is("namespace", 1)) || (is("extern") && is("\"", 1)))
            readNamespace(scope);
        else if (is("using") || is("typedef") || is("friend") || is("static_assert") || is("enum"))
            skipStatement();
        else if (!((is("class") || is("struct") || is("union")) && readClass(scope)))
            readFunctionOrVariable(scope, members, isPublic);
    }

    /// Skips a macro such as Q_OBJECT or Q_PROPERTY(...). Returns false if there is none.
    bool skipMacro()
    {
        if (m_at >= m_tokens.size() || !m_tokens[m_at].text.starts_with("Q_"))
            return false;
        ++m_at;
        if (is("("))
            skipBrackets();
        return true;
    }

    void readNamespace(const std::string& scope)
    {
        std::string inner = scope;
        for (; m_at < m_tokens.size() && !is("{"); ++m_at) {
            if (is(";") || is("=")) // a namespace alias, or extern "C" of one function
                return skipStatement();
            if (isWord(m_tokens[m_at]) && !is("namespace") && !is("inline") && !is("extern"))
                inner += "::" + m_tokens[m_at].text;
        }
        take("{");
        readScope(inner, nullptr);
        close();
    }

    void close()
    {
        if (!take("}"))
            m_outline.isBalanced = false;
    }

    /// Returns false and reads nothing if no class definition follows.
    bool readClass(const std::string& scope)
    {
        const std::size_t begin = m_at;
        const bool isPublic = !is("class");
        std::string name;
        for (++m_at; m_at < m_tokens.size() && !is("{") && !is(":"); ++m_at) {
            if (is("<")) { // template arguments of a specialisation
                skipBalanced("<", ">");
                --m_at;
            } else if (is("[")) {
                skipBrackets();
                --m_at;
            } else if (is("::") || (isWord(m_tokens[m_at]) && !is("final"))) {
                name += m_tokens[m_at].text;
            } else if (!is("final")) { // a class name in some other declaration
                m_at = begin;
                return false;
            }
        }
        while (m_at < m_tokens.size() && !is("{"))
            ++m_at;
        take("{");
        ClassOutline members{qualified(scope, name), m_tokens[begin].line};
        readScope(scope + "::" + name, &members, isPublic);
        close();
        m_outline.classes.push_back(members);
        skipStatement(); // skips the variables declared with the class
        return true;
    }

    static std::string qualified(const std::string& scope, const std::string& name)
    {
        return scope.empty() ? name : scope.substr(2) + "::" + name;
    }

    /// Reads a function or a variable. A function has a parameter list: a bracket after its name and before any '=' or
    /// '{'.
    void readFunctionOrVariable(const std::string& scope, ClassOutline* members, bool isPublic)
    {
        const std::string name = readDeclarator();
        if (name.empty())
            return skipStatement();
        const int line = m_line;
        skipBrackets();
        if (is("(")) // pointer to a function, for example int (*pointer)(int)
            return skipStatement();
        const bool isDefaulted = skipSpecifiers();
        if (members && !isDefaulted)
            ++(isPublic ? members->publicFunctions : members->privateFunctions);
        if (is("{")) {
            skipBrackets();
            m_outline.functions.push_back({qualified(scope, name), line, m_tokens[m_at - 1].line - line + 1});
        }
        take(";");
    }

    /// Moves to the parameter list and returns the name before it. Without one, returns an empty text at some position
    /// inside the statement.
    std::string readDeclarator()
    {
        std::string name;
        for (bool isGlued = false; m_at < m_tokens.size() && !is(";") && !is("}") && !is("{") && !is("=");) {
            if (take("operator"))
                return name + readOperator();
            if (is("("))
                return is("*", 1) ? std::string() : name;
            if (is("alignas") || is("decltype") || is("explicit")) {
                ++m_at;
                if (is("("))
                    skipBrackets();
            } else if (is("<")) {
                skipBalanced("<", ">");
            } else if (is("[")) {
                skipBrackets();
            } else if (take("::")) {
                name += "::";
                isGlued = true;
            } else {
                const std::string& text = m_tokens[m_at++].text;
                const bool isName = isWordCharacter(text.front()) || text == "~";
                name = isName ? (isGlued ? name + text : text) : std::string();
                isGlued = text == "~";
            }
        }
        return {};
    }

    /// Reads the name of an operator function. Precondition: the position is after the word "operator".
    std::string readOperator()
    {
        std::string name = "operator";
        if (is("(")) { // the name operator()
            m_at += 2;
            return name + "()";
        }
        for (; m_at < m_tokens.size() && !is("("); ++m_at)
            name += m_tokens[m_at].text;
        return name;
    }

    /// Skips const, noexcept(...), trailing return types and member initialisers. Returns whether the function is
    /// defaulted or deleted.
    bool skipSpecifiers()
    {
        while (m_at < m_tokens.size() && !is("{") && !is(";") && !is("}")) {
            if (take(":"))
                skipInitialisers();
            else if (take("="))
                return is("default") || is("delete") ? (skipStatement(), true) : false;
            else if (!skipBrackets())
                ++m_at;
        }
        return false;
    }

    void skipInitialisers()
    {
        do {
            while (m_at < m_tokens.size() && !is("(") && !is("{"))
                ++m_at;
            skipBrackets();
        } while (take(","));
    }

    std::vector<Token> m_tokens;
    std::size_t m_at = 0;
    int m_line = 0; ///< line of the declaration
    SourceOutline m_outline;
};
} // namespace

SourceOutline outlineOf(std::string_view source)
{
    return Parser(Scanner(source).tokens()).outline();
}
