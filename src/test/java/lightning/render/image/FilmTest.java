package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class FilmTest {

    @Test
    void pixelInSecondTileRow_matchesLayout() {
        Film film = Film.black(70, 40);
        film.green(4)[3 * 32 + 5] = 7;

        assertThat(film.tilesX()).isEqualTo(3);
        assertThat(film.tilesY()).isEqualTo(2);
        assertThat(film.tileCount()).isEqualTo(6);
        assertThat(film.green(32 + 5, 32 + 3)).isEqualTo(7);
    }

    @Test
    void fullTile_needsNoSecondTile() {
        assertThat(Film.black(32, 64).tilesX()).isEqualTo(1);
        assertThat(Film.black(32, 64).tilesY()).isEqualTo(2);
        assertThat(Film.black(33, 1).tilesX()).isEqualTo(2);
    }

    @Test
    void scanlines_areInterleavedFromTop() {
        Film film = Film.ofScanlines(2, 2, new float[] {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});

        assertThat(film.red(1, 0)).isEqualTo(4);
        assertThat(film.green(0, 1)).isEqualTo(8);
        assertThat(film.blue(1, 1)).isEqualTo(12);
    }

    @Property
    void scanlines_roundTrip_keepsBits(@ForAll("films") Film film) {
        float[] rgb = film.toScanlines();

        assertThat(Film.ofScanlines(film.width(), film.height(), rgb).hasSameBits(film)).isTrue();
        assertThat(rgb).hasSize(3 * film.width() * film.height());
    }

    @Property
    void flippedBit_isDetected(@ForAll("films") Film film, @ForAll int where, @ForAll @IntRange(max = 31) int bit) {
        float[] rgb = film.toScanlines();
        int at = Math.floorMod(where, rgb.length);
        int flipped = Float.floatToRawIntBits(rgb[at]) ^ 1 << bit;
        rgb[at] = Float.intBitsToFloat(flipped);

        assertThat(Film.ofScanlines(film.width(), film.height(), rgb).hasSameBits(film)).isFalse();
    }

    @Test
    void pixelsOutsideImage_areIgnored() {
        Film film = Film.black(3, 3);
        film.red(0)[3] = 1;

        assertThat(film.hasSameBits(Film.black(3, 3))).isTrue();
    }

    @Test
    void filmsOfDifferentSize_areDifferent() {
        assertThat(Film.black(3, 4).hasSameBits(Film.black(4, 3))).isFalse();
    }

    @Test
    void copy_hasOwnArrays() {
        Film film = RandomFilms.gray(3, 3, 1);
        Film copy = film.copy();
        film.blue(0)[0] = 2;

        assertThat(copy.blue(0, 0)).isEqualTo(1);
    }

    @Test
    void wrongArraySizes_areRejected() {
        float[][] two = new float[2][Film.TILE_PIXELS];
        float[][] cut = new float[1][Film.TILE_PIXELS - 1];
        float[][] one = new float[1][Film.TILE_PIXELS];

        assertThatThrownBy(() -> new Film(8, 8, one, two, one)).hasMessageContaining("green has 2");
        assertThatThrownBy(() -> new Film(8, 8, one, one, cut)).hasMessageContaining("tile 0 of blue has 1023");
        assertThatThrownBy(() -> Film.black(0, 8)).hasMessageContaining("at least 1");
        assertThatThrownBy(() -> Film.ofScanlines(2, 2, new float[11])).hasMessageContaining("needs 12 values, not 11");
    }

    @Provide
    Arbitrary<Film> films() {
        return RandomFilms.anyBits();
    }
}
