package lightning.format.jen;

/**
 * Syntax of names in files and edits: a plain word, else in double quotes, with a backslash before each double quote and
 * backslash: {@code key}, {@code "key light"}, {@code "3\" pipe"}.
 */
public final class NameSyntax {
    private NameSyntax() {}

    /** Returns the text that reads back as {@code name}. */
    public static String format(String name) {
        return isWord(name) ? name : quote(name);
    }

    /** Returns the name in quotes, even if it is a plain word. */
    static String quote(String name) {
        return '"' + name.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }

    /** Parses a name with or, since its end is known, without quotes. */
    static String parse(String text) {
        return isQuoted(text) && closingQuote(text, 0) == text.length() - 1 ? unescape(text.substring(1, text.length() - 1)) : text;
    }

    static boolean isQuoted(String text) {
        return text.startsWith("\"");
    }

    /** Returns the offset of the closing quote in the same line for the quote at {@code start}, or −1. */
    static int closingQuote(String text, int start) {
        for (int i = start + 1; i < text.length() && text.charAt(i) != '\n'; i++) {
            if (text.charAt(i) == '"') {
                return i;
            }
            if (text.charAt(i) == '\\' && i + 1 < text.length() && isEscapable(text.charAt(i + 1))) {
                i++;
            }
        }
        return -1;
    }

    /** Returns whether the character can be escaped by a backslash. */
    static boolean isEscapable(char c) {
        return c == '"' || c == '\\';
    }

    /** Returns the characters between two quotes with escapes resolved. */
    static String unescape(String content) {
        if (content.indexOf('\\') < 0) {
            return content;
        }
        var out = new StringBuilder(content.length());
        for (int i = 0; i < content.length(); i++) {
            char c = content.charAt(i);
            if (c == '\\' && i + 1 < content.length() && isEscapable(content.charAt(i + 1))) {
                i++;
            }
            out.append(content.charAt(i));
        }
        return out.toString();
    }

    static boolean isWordStart(int c) {
        return c == '_' || Character.isLetter(c);
    }

    static boolean isWordPart(int c) {
        if (c == '_' || c == '-' || Character.isLetterOrDigit(c)) {
            return true;
        }
        int type = Character.getType(c);
        return type == Character.LETTER_NUMBER || type == Character.OTHER_NUMBER;
    }

    private static boolean isWord(String name) {
        return !name.isEmpty() && isWordStart(name.codePointAt(0)) && name.codePoints().allMatch(NameSyntax::isWordPart);
    }
}
