package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import lightning.format.image.ImageFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FilmAssertTest {

    @TempDir
    Path failures;

    @Test
    void sameBits_passAndWriteNoFiles() {
        Film film = RandomFilms.anyBits(40, 35, 1);

        FilmAssert.assertSameBits(film, film.copy(), "same", failures);

        assertThat(failures).isEmptyDirectory();
    }

    @Test
    void oneBit_failsWithPositionValuesCountAndImages() throws IOException {
        Film expected = RandomFilms.gray(40, 35, 1);
        Film actual = RandomFilms.withGreen(expected, 36, 33, Math.nextUp(1f));

        assertThatThrownBy(() -> FilmAssert.assertSameBits(actual, expected, "a b", failures))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("1 of 1400 pixels (1 values) differ in bits, by at most 1 ulp")
                .hasMessageContaining("at (36, 33) expected 1.0=0x3f800000 1.0=0x3f800000")
                .hasMessageContaining("but was 1.0=0x3f800000 1.0000001=0x3f800001")
                .hasMessageContaining(failures.resolve("a_b").toString());
        for (String name : new String[] {"actual.png", "expected.png", "difference.png"}) {
            Film picture = ImageFile.read(failures.resolve("a_b").resolve(name));
            assertThat(picture.width()).isEqualTo(40);
        }
    }

    @Test
    void otherSizes_fail() {
        assertThatThrownBy(() -> FilmAssert.assertSameBits(Film.black(2, 3), Film.black(3, 2), "size", failures))
                .hasMessageContaining("expected 3 × 2 pixels, but was 2 × 3 pixels");
    }
}
