package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.document.TextDifference.Row;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class TextDifferenceTest {

    @Test
    void changedLine_isInOneRow() {
        assertThat(TextDifference.rows("a\nb\nc\n", "a\nx\nc\n")).containsExactly(
                new Row(1, "a", 1, "a"), new Row(2, "b", 2, "x"), new Row(3, "c", 3, "c"));
    }

    @Test
    void shortenedLines_showTheDifferenceInsteadOfEqualText() {
        String start = "light key spot { color 1 0.9 0.8  at 3 5 2  direction -3 -4 -2  angle 25  dropoff 4  intensity ";
        Row row = new Row(7, start + "0.25 }", 7, start + "0.75 }");
        Row shown = row.shortened(64);
        assertThat(shown.mine()).startsWith("light key spot {").endsWith("intensity 0.25 }").hasSizeLessThanOrEqualTo(64);
        assertThat(shown.theirs()).isEqualTo(shown.mine().replace("0.25", "0.75"));
        assertThat(shown.isSame()).isFalse();
    }

    @Test
    void shortenedEqualLines_areCutAtTheirEnd() {
        String line = "0123456789".repeat(10);
        assertThat(new Row(1, line, 1, line).shortened(12)).isEqualTo(new Row(1, "0123456789 …", 1, "0123456789 …"));
        assertThat(new Row(1, line, 1, line).shortened(100).mine()).isEqualTo(line);
    }

    @Property
    void shortenedLines_fitAndDifferWhereTheLinesDiffer(@ForAll("longLines") String head, @ForAll("longLines") String mine,
            @ForAll("longLines") String theirs) {
        Row row = new Row(1, head + "<" + mine, 1, head + ">" + theirs).shortened(30);
        assertThat(row.mine()).hasSizeLessThanOrEqualTo(30).contains("<");
        assertThat(row.theirs()).hasSizeLessThanOrEqualTo(30).contains(">");
        assertThat(row.mine().indexOf('<')).isEqualTo(row.theirs().indexOf('>'));
    }

    @Provide
    Arbitrary<String> longLines() {
        return Arbitraries.strings().withCharRange('a', 'z').ofMaxLength(80);
    }

    @Test
    void lineOfOneText_hasEmptyOtherSide() {
        assertThat(TextDifference.rows("a\nc\n", "a\nb\nc\n")).containsExactly(
                new Row(1, "a", 1, "a"), new Row(0, "", 2, "b"), new Row(2, "c", 3, "c"));
        assertThat(TextDifference.rows("a", "")).containsExactly(new Row(1, "a", 0, ""));
    }

    @Test
    void emptyLine_differsFromMissingLine() {
        assertThat(TextDifference.rows("\n", "")).singleElement().matches(row -> !row.isSame());
    }

    @Test
    void movedLines_keepLongestCommonRun() {
        List<Row> rows = TextDifference.rows("1\n2\n3\n4\n5", "4\n5\n1\n2\n3");
        assertThat(rows.stream().filter(Row::isSame).map(Row::mine)).containsExactly("1", "2", "3");
    }

    @Test
    void tooLargeDifference_isShownSideBySide() {
        String mine = numbered(5000, "a");
        String theirs = numbered(5000, "b");
        assertThat(TextDifference.rows("x\n" + mine + "y", "x\n" + theirs + "y")).hasSize(5002)
                .first().matches(Row::isSame);
    }

    private static String numbered(int lines, String word) {
        return IntStream.range(0, lines).mapToObj(i -> word + i + "\n").collect(Collectors.joining());
    }

    @Property
    void rows_containBothTextsInOrderWithNumbers(@ForAll("lines") List<String> mine, @ForAll("lines") List<String> theirs) {
        List<Row> rows = TextDifference.rows(text(mine), text(theirs));
        List<Row> left = rows.stream().filter(r -> r.mineLine() > 0).toList();
        List<Row> right = rows.stream().filter(r -> r.theirsLine() > 0).toList();
        assertThat(left).extracting(Row::mine).isEqualTo(mine);
        assertThat(right).extracting(Row::theirs).isEqualTo(theirs);
        assertThat(left).extracting(Row::mineLine).isEqualTo(IntStream.rangeClosed(1, mine.size()).boxed().toList());
        assertThat(right).extracting(Row::theirsLine).isEqualTo(IntStream.rangeClosed(1, theirs.size()).boxed().toList());
    }

    @Property
    void equalTexts_haveOnlySameRows(@ForAll("lines") List<String> lines) {
        assertThat(TextDifference.rows(text(lines), text(lines))).hasSize(lines.size()).allMatch(Row::isSame);
    }

    @Provide
    Arbitrary<List<String>> lines() {
        return Arbitraries.of("", "a", "b", "c").list().ofMaxSize(8);
    }

    private static String text(List<String> lines) {
        return lines.stream().map(line -> line + "\n").collect(Collectors.joining());
    }
}
