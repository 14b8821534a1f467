package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PoParserTest {
    @Test
    void entries_areReadWithoutHeaderAndComments() {
        assertThat(new PoParser("""
                msgid ""
                msgstr "Language: de\\n"

                #: a reference
                msgid "Open"
                msgstr "Öffnen"
                """).parse()).isEqualTo(Map.of("Open", "Öffnen"));
    }

    @Test
    void continuationLinesAndEscapes_areJoined() {
        assertThat(new PoParser("""
                msgid "a\\n"
                "b \\"c\\""
                msgstr "d\\\\"
                "\\te"
                """).parse()).isEqualTo(Map.of("a\nb \"c\"", "d\\\te"));
    }

    @Test
    void fuzzyAndEmptyTranslations_areSkipped() {
        assertThat(new PoParser("""
                #, fuzzy
                msgid "a"
                msgstr "b"

                msgid "c"
                msgstr ""

                msgid "d"
                msgstr "e"
                """).parse()).isEqualTo(Map.of("d", "e"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "msgid \"a\"\\nmsgstr \"b\"\\nmsgid \"a\"\\nmsgstr \"c\" | line 4: duplicate msgid 'a'",
        "msgid \"a\"\\nmsgid \"b\" | line 2: expected msgstr for 'a'",
        "msgstr \"b\" | line 1: expected msgid",
        "msgid a | line 1: expected a text in quotes, found 'a'",
        "msgid \"\\q\" | line 1: unknown escape \\q",
        "Open | line 1: expected msgid, msgstr or a quoted text, found 'Open'"})
    void faultyCatalog_isRejectedWithItsLine(String lines, String message) {
        assertThatThrownBy(() -> new PoParser(lines.replace("\\n", "\n")).parse()).hasMessageContaining(message);
    }
}
