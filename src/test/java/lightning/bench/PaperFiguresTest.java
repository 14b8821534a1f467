package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import lightning.format.jen.JenReader;
import lightning.scene.paper.PaperCase;
import lightning.scene.paper.PaperCases;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PaperFiguresTest {
    private static List<String> cases(int figure) throws Exception {
        return PaperCases.of(JenReader.read(Path.of("scenes/bird.jen")).scene()).stream().filter(edit -> PaperFigures.shows(figure, edit))
                .map(PaperCase::name).toList();
    }

    @ParameterizedTest
    @CsvSource({"6, color intensity", "7, color intensity", "8, attenuation", "9, attenuation", "10, angle-smaller angle-larger",
        "11, angle-smaller angle-larger", "13, dropoff", "14, dropoff", "15, position direction type", "16, position direction type",
        "17, delete", "18, delete", "19, add", "20, add", "21, ambience", "22, ambience", "23, position-feet",
        "24, composite-1 composite-2", "25, composite-1 composite-2"})
    void figure_includesItsEdits(int figure, String names) throws Exception {
        assertThat(cases(figure)).containsExactly(names.split(" "));
        assertThat(PaperFigures.isMeasured(figure)).isTrue();
    }

    @Test
    void figure26_includesEveryPrintedEdit() throws Exception {
        assertThat(cases(26)).hasSize(15).contains("color", "composite-2").doesNotContain("rename");
        assertThat(PaperFigures.isMeasured(26)).isTrue();
    }

    /** The paper's Appendix B has four examples: reflective balls, space ship, desk and house. */
    @ParameterizedTest
    @CsvSource({"B1, balls", "B2, spaceship", "b3, desk", "B4, house", "B, balls spaceship desk house", "24, bird"})
    void subject_hasScenesOfItsPaperSection(String name, String scenes) {
        assertThat(PaperFigures.parse(name)).get().satisfies(subject -> assertThat(subject.scenes()).containsExactly(scenes.split(" ")));
    }

    @Test
    void appendixB_includesEveryPrintedEdit() throws Exception {
        assertThat(cases(PaperFigures.parse("B2").orElseThrow().figure())).isEqualTo(cases(26));
    }

    @ParameterizedTest
    @CsvSource({"B0", "B5", "C", "BB", "12", "-6", "1e1", "99999999999", "''"})
    void otherNames_haveNoSubject(String name) {
        assertThat(PaperFigures.parse(name)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0", "1", "5", "12", "27", "-6"})
    void otherFigures_areNotMeasured(int figure) throws Exception {
        assertThat(PaperFigures.isMeasured(figure)).isFalse();
        assertThat(cases(figure)).isEmpty();
    }
}
