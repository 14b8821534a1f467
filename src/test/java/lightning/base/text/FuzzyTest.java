package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.AlphaChars;
import net.jqwik.api.constraints.StringLength;
import org.junit.jupiter.api.Test;

class FuzzyTest {
    private static int fit(String query, String title) {
        return Fuzzy.fit(query, title).orElseThrow();
    }

    @Test
    void lettersThatBeginWords_fitBest() {
        assertThat(fit("ssa", "Save Scene As…")).isGreaterThan(fit("ssa", "Message saved")).isGreaterThan(fit("ssa", "Missal"));
    }

    @Test
    void lettersSideBySide_fitBetterThanScattered() {
        assertThat(fit("und", "Roundel")).isGreaterThan(fit("und", "Turn blinds"));
    }

    @Test
    void best_isFoundWhereTheFirstLettersLeadAstray() {
        assertThat(fit("sc", "success scene")).isEqualTo(fit("sc", "xxxxxxxx scene"));
    }

    @Test
    void words_mayComeInAnyOrderAndCase() {
        assertThat(Fuzzy.fit("LIGHT dup", "Duplicate Light")).isPresent();
    }

    @Test
    void letterThatIsMissing_fitsNothing() {
        assertThat(Fuzzy.fit("undq", "Undo")).isEmpty();
        assertThat(Fuzzy.fit("odnu", "Undo")).isEmpty();
    }

    @Test
    void noLetters_fitAllAlike() {
        assertThat(Fuzzy.fit(" ", "Undo")).isEqualTo(Fuzzy.fit("", "Redo")).hasValue(0);
    }

    @Property
    void letters_fitExactlyWhereTheyStandInTheirOrder(@ForAll @AlphaChars @StringLength(max = 4) String query,
            @ForAll @AlphaChars @StringLength(max = 12) String title) {
        String pattern = "(?i).*" + String.join(".*", query.split("")) + ".*";
        assertThat(Fuzzy.fit(query, title).isPresent()).isEqualTo(title.matches(pattern));
    }

    @Test
    void help_holdsWholeWords() {
        assertThat(Fuzzy.holds("full trace", "Trace the picture in full")).isEqualTo(OptionalInt.of(0));
        assertThat(Fuzzy.holds("fult", "Trace the picture in full")).isEmpty();
    }
}
