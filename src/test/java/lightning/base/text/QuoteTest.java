package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.StringLength;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class QuoteTest {
    @Test
    void printableText_isQuotedUnchanged() {
        assertThat(Quote.of("old oak")).isEqualTo("'old oak'");
        assertThat(Quote.of("a\\b \"c\"")).isEqualTo("'a\\b \"c\"'");
        assertThat(Quote.of("می\u200Cخواهم 👩\u200D🎨")).isEqualTo("'می\u200Cخواهم 👩\u200D🎨'");
        assertThat(Quote.path("scenes/old oak.jen")).isEqualTo("scenes/old oak.jen");
    }

    /** Expects the output of {@code git -c core.quotePath=true ls-files} for files of these names. */
    @Test
    void unprintableCharacters_areEscapedLikeGit() {
        assertThat(Quote.path("a\nb\t\"c\"\\")).isEqualTo("\"a\\nb\\t\\\"c\\\"\\\\\"");
        assertThat(Quote.path("\u0007\b\u000B\f\r\u001B[31m\u007F")).isEqualTo("\"\\a\\b\\v\\f\\r\\033[31m\\177\"");
        assertThat(Quote.path("a\u0085\u202Eb\u2028\uDB40\uDC01"))
                .isEqualTo("\"a\\302\\205\\342\\200\\256b\\342\\200\\250\\363\\240\\200\\201\"");
        assertThat(Quote.path("\"quoted\"")).isEqualTo("\"\\\"quoted\\\"\"");
        assertThat(Quote.of("key\nlight")).isEqualTo("\"key\\nlight\"");
        assertThat(Quote.of("\uD835")).isEqualTo("\"\\355\\240\\265\"");
    }

    @ParameterizedTest
    @CsvSource({"a, 100, 100, ''", "a, 101, 99, …", "𝐀, 100, 100, ''", "𝐀, 101, 99, …", "𝐀, 1000000, 99, …"})
    void longText_isShortenedTo100Characters(String character, int times, int shown, String rest) {
        assertThat(Quote.of(character.repeat(times))).isEqualTo("'" + character.repeat(shown) + rest + "'");
    }

    @Property
    void anyText_isQuotedInOnePrintableLine(@ForAll @StringLength(max = 300) String text) {
        String quoted = Quote.of(text);
        assertThat(PrintableText.isPrintable(quoted)).isTrue();
        assertThat(quoted.codePointCount(0, quoted.length())).isLessThanOrEqualTo(2 + 12 * 100);
        assertThat(PrintableText.isPrintable(Quote.path(text))).isTrue();
    }

    @Test
    void longPath_isShortenedInTheMiddle() {
        String longest = "a".repeat(499) + "z";
        assertThat(Quote.path(longest)).isEqualTo(longest);
        assertThat(Quote.path("start/" + "\uD83D\uDE00".repeat(3000) + "/end.jen")).startsWith("start/").endsWith("/end.jen").contains("…")
                .satisfies(shown -> assertThat(shown.codePointCount(0, shown.length())).isEqualTo(500));
    }
}
