package lightning.render.trace.primitive;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap;
import lightning.scene.asset.TextureWrap.Edge;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** An image of four gray columns, 0, 0.25, 0.5 and 1. */
class BilinearLookupTest {
    private static final float[] COLUMNS = {0, 0.25f, 0.5f, 1};
    private static final Texture IMAGE = image();

    private final BilinearLookup lookup = new BilinearLookup();

    private static Texture image() {
        float[] rgb = new float[12];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = COLUMNS[i / 3];
        }
        return new Texture(4, 1, rgb);
    }

    private float read(Edge edge, double repeat, double u) {
        lookup.setCoordinates(new TextureMap("a.png", repeat, 1, IMAGE, new TextureWrap(edge, Edge.REPEAT)), u, 0.5);
        return lookup.red();
    }

    private double slope(Edge edge, double u) {
        read(edge, 1, u);
        return lookup.slopeU();
    }

    @ParameterizedTest
    @CsvSource({"REPEAT, 0, 0.5", "REPEAT, 1.125, 0", "REPEAT, -0.125, 1", "REPEAT, -3.375, 0.5",
        "CLAMP, 0, 0", "CLAMP, -7.5, 0", "CLAMP, 0.625, 0.5", "CLAMP, 1, 1", "CLAMP, 12.5, 1",
        "MIRROR, 0, 0", "MIRROR, 1, 1", "MIRROR, 1.125, 1", "MIRROR, 1.375, 0.5", "MIRROR, -0.375, 0.25", "MIRROR, 2.375, 0.25"})
    void edge_decidesWhatFollows(Edge edge, double u, float expected) {
        assertThat(read(edge, 1, u)).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource({"CLAMP, 0.125, 1", "CLAMP, 0.875, 0", "CLAMP, 1.5, 0", "CLAMP, -0.5, 1", "MIRROR, 0.125, 1", "MIRROR, 1.125, 0"})
    void negativeRepeat_mirrorsInPlace(Edge edge, double u, float expected) {
        assertThat(read(edge, -1, u)).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource({"REPEAT, 0.375, 1", "MIRROR, 0.375, 1", "MIRROR, 1.625, -1", "CLAMP, 0.375, 1", "CLAMP, 1.375, 0", "CLAMP, -0.375, 0",
        "CLAMP, 0.125, 0.5", "MIRROR, 0.125, 0.5", "REPEAT, 0.125, -1.5"})
    void slope_isTheDerivativeOfWhatIsShown(Edge edge, double u, double expected) {
        // Central differences over two columns of a quarter each.
        assertThat(slope(edge, u)).isEqualTo(expected, within(1e-12));
    }

    @Property
    void repetition_hasPeriod1_mirrorsHavePeriod2(@ForAll @DoubleRange(min = -4, max = 4) double u,
            @ForAll @IntRange(min = -3, max = 3) int n) {
        assertThat(read(Edge.REPEAT, 1, u + n)).isEqualTo(read(Edge.REPEAT, 1, u), within(1e-6f));
        assertThat(read(Edge.MIRROR, 1, u + 2 * n)).isEqualTo(read(Edge.MIRROR, 1, u), within(1e-6f));
        assertThat(read(Edge.MIRROR, 1, -u)).isEqualTo(read(Edge.MIRROR, 1, u), within(1e-6f));
    }

    @ParameterizedTest
    @CsvSource({"0.25, 0, 0, 0.375, 0, 0.5", "0, 0, 90, 0.3, -0.625, 0.5", "0.125, 0, 180, -0.25, 0.1, 0.25",
        "0, 7, -90, 0.3, 0.375, 0.25"})
    void placement_turnsThenMoves(double offsetU, double offsetV, double rotation, double u, double v, float expected) {
        lookup.setCoordinates(placed(1, 1, TextureWrap.REPEAT, new TexturePlacement(offsetU, offsetV, rotation)), u, v);
        assertThat(lookup.red()).isEqualTo(expected, within(1e-6f));
    }

    private static TextureMap placed(double repeatU, double repeatV, TextureWrap wrap, TexturePlacement placement) {
        return new TextureMap("a.png", repeatU, repeatV, IMAGE, wrap, placement);
    }

    @Test
    void repeats_comeBeforeTheRotation() {
        // (0.1 · 2, −0.1 · 3.75) turned by 90° is (0.375, 0.2).
        lookup.setCoordinates(placed(2, 3.75, TextureWrap.REPEAT, new TexturePlacement(0, 0, 90)), 0.1, -0.1);
        assertThat(lookup.red()).isEqualTo(0.25f, within(1e-6f));
    }

    @Test
    void lookupWithoutPlacement_isThatOfItsOwnMap() {
        lookup.setCoordinates(placed(1, 1, TextureWrap.REPEAT, new TexturePlacement(0.5, 0, 45)), 0.375, 0);
        lookup.setCoordinates(placed(1, 1, TextureWrap.REPEAT, TexturePlacement.NONE), 0.375, 0);
        assertThat(lookup.red()).isEqualTo(0.25f);
        assertThat(lookup.alongU(3, 4)).isEqualTo(3);
        assertThat(lookup.alongV(3, 4)).isEqualTo(4);
    }

    /** The directions along u and v are those in which the image was turned. */
    @Test
    void directions_turnBack() {
        lookup.setCoordinates(placed(1, 1, TextureWrap.REPEAT, new TexturePlacement(0, 0, 90)), 0.1, 0.1);
        // u grows where the image's v does, and v where its u falls.
        assertThat(lookup.alongU(0, 1)).isEqualTo(1, within(1e-12));
        assertThat(lookup.alongV(1, 0)).isEqualTo(-1, within(1e-12));
    }

    @Test
    void axes_areIndependent() {
        var tall = new Texture(1, 2, new float[] {1, 1, 1, 0, 0, 0});
        lookup.setCoordinates(new TextureMap("a.png", 1, 1, tall, new TextureWrap(Edge.REPEAT, Edge.CLAMP)), 0.5, 7);
        assertThat(lookup.red()).isEqualTo(1);
        lookup.setCoordinates(new TextureMap("a.png", 1, 1, tall, TextureWrap.REPEAT), 0.5, 7);
        assertThat(lookup.red()).isEqualTo(0.5f);
    }
}
