package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import lightning.accuracy.PaperCase;
import lightning.accuracy.PaperCases;
import lightning.jen.JenReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FiguresTest {
    private static List<String> cases(int figure) throws Exception {
        return PaperCases.of(JenReader.read(Path.of("scenes/bird.jen")).scene()).stream().filter(edit -> Figures.shows(figure, edit))
                .map(PaperCase::name).toList();
    }

    @ParameterizedTest
    @CsvSource({"6, color intensity", "7, color intensity", "8, attenuation", "9, attenuation", "10, angle-smaller angle-larger",
        "11, angle-smaller angle-larger", "13, dropoff", "14, dropoff", "15, position direction type", "16, position direction type",
        "17, delete", "18, delete", "19, add", "20, add", "21, ambience", "22, ambience", "23, position-feet",
        "24, composite-1 composite-2", "25, composite-1 composite-2"})
    void figure_showsItsEdits(int figure, String names) throws Exception {
        assertThat(cases(figure)).containsExactly(names.split(" "));
        assertThat(Figures.isMeasured(figure)).isTrue();
    }

    @Test
    void figure26_showsEveryPrintedEdit() throws Exception {
        assertThat(cases(26)).hasSize(15).contains("color", "composite-2").doesNotContain("rename");
        assertThat(Figures.isMeasured(26)).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"0", "1", "5", "12", "27", "-6"})
    void otherFigures_showNoTimes(int figure) throws Exception {
        assertThat(Figures.isMeasured(figure)).isFalse();
        assertThat(cases(figure)).isEmpty();
    }
}
