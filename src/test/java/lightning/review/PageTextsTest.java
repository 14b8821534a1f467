package lightning.review;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.base.text.Language;
import lightning.base.text.Messages;
import org.junit.jupiter.api.Test;

class PageTextsTest {
    private static final Pattern IN_SCRIPT = Pattern.compile("\\btr\\(\"([^\"]*)\"");
    private static final Pattern IN_MARKUP = Pattern.compile("data-(?:text|label|title)=\"([^\"]*)\"");

    @Test
    void listedTexts_areThoseOfThePage() throws IOException {
        var used = new TreeSet<String>();
        String page = ReviewPage.frame("'none'");
        Stream.concat(IN_SCRIPT.matcher(page).results(), IN_MARKUP.matcher(page).results())
                .forEach(match -> used.add(match.group(1)));
        assertThat(new TreeSet<>(PageTexts.ALL)).isEqualTo(used);
    }

    @Test
    void everyText_isGermanToo() {
        assertThat(PageTexts.ALL).filteredOn(text -> Messages.in(Language.GERMAN, text).equals(text)).containsExactly("Solo {0}");
        assertThat(PageTexts.json().get("de").size()).isEqualTo(PageTexts.ALL.size());
    }
}
