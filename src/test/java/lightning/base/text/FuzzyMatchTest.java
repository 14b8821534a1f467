package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.AlphaChars;
import net.jqwik.api.constraints.StringLength;
import org.junit.jupiter.api.Test;

class FuzzyMatchTest {
    private static int fit(String query, String title) {
        return FuzzyMatch.score(query, title).orElseThrow();
    }

    @Test
    void wordInitials_scoreHighest() {
        assertThat(fit("ssa", "Save Scene As…")).isGreaterThan(fit("ssa", "Message saved")).isGreaterThan(fit("ssa", "Missal"));
    }

    @Test
    void adjacentLetters_scoreHigherThanScattered() {
        assertThat(fit("und", "Roundel")).isGreaterThan(fit("und", "Turn blinds"));
    }

    @Test
    void bestScore_isFoundDespiteEarlierLetters() {
        assertThat(fit("sc", "success scene")).isEqualTo(fit("sc", "xxxxxxxx scene"));
    }

    @Test
    void words_matchInAnyOrderAndCase() {
        assertThat(FuzzyMatch.score("LIGHT dup", "Duplicate Light")).isPresent();
    }

    @Test
    void missingLetter_doesNotMatch() {
        assertThat(FuzzyMatch.score("undq", "Undo")).isEmpty();
        assertThat(FuzzyMatch.score("odnu", "Undo")).isEmpty();
    }

    @Test
    void emptyQuery_matchesEverything() {
        assertThat(FuzzyMatch.score(" ", "Undo")).isEqualTo(FuzzyMatch.score("", "Redo")).hasValue(0);
    }

    @Property
    void letters_matchOnlyInOrder(@ForAll @AlphaChars @StringLength(max = 4) String query,
            @ForAll @AlphaChars @StringLength(max = 12) String title) {
        String pattern = "(?i).*" + String.join(".*", query.split("")) + ".*";
        assertThat(FuzzyMatch.score(query, title).isPresent()).isEqualTo(title.matches(pattern));
    }

    @Test
    void helpText_matchesWholeWords() {
        assertThat(FuzzyMatch.containsWords("full trace", "Trace the picture in full")).isEqualTo(OptionalInt.of(0));
        assertThat(FuzzyMatch.containsWords("fult", "Trace the picture in full")).isEmpty();
    }
}
