package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The German texts use one word for one thing. */
class GermanTermsTest {
    private static final Pattern ENTRY = Pattern.compile("msgid \"(.*)\"\nmsgstr \"(.*)\"");

    private static List<MatchResult> entries() throws IOException {
        return ENTRY.matcher(Files.readString(Path.of("src/main/resources/lightning/base/text/de.po"))).results().toList();
    }

    @Test
    void shot_isNotTheWordForASetting() throws IOException {
        assertThat(entries()).isNotEmpty().noneMatch(
                entry -> Pattern.compile("(?i)\\bshots?\\b").matcher(entry.group(1)).find() && entry.group(2).contains("Einstellung"));
    }

    @Test
    void rimLight_hasOneName() throws IOException {
        assertThat(entries()).noneMatch(entry -> entry.group(2).matches(".*(Lichtsaum|Streiflicht).*"));
        assertThat(entries()).filteredOn(entry -> entry.group(1).toLowerCase(Locale.ROOT).contains("rim light"))
                .allMatch(entry -> entry.group(2).contains("antenlicht"));
    }

    @Test
    void master_isNoSum() throws IOException {
        assertThat(entries()).filteredOn(entry -> entry.group(1).toLowerCase(Locale.ROOT).contains("master"))
                .allMatch(entry -> entry.group(2).contains("Master"));
    }
}
