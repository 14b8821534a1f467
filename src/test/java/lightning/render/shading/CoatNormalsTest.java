package lightning.render.shading;

import static lightning.render.shading.SurfaceMapsTest.floor;
import static lightning.render.shading.SurfaceMapsTest.map;
import static lightning.render.shading.SurfaceMapsTest.scene;
import static lightning.render.shading.SurfaceMapsTest.trace;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.BumpMapping;
import lightning.scene.material.Coat;
import lightning.scene.material.CoatNormals;
import lightning.scene.material.LayerMaps;
import lightning.scene.material.Material;
import lightning.scene.material.ShadingModel;
import org.junit.jupiter.api.Test;

/** Tests that a coat has normals of its own, which bumps of the surface do not change. */
class CoatNormalsTest {
    /** A black surface under a coat: only the coat reflects. */
    private static final Material COATED = Material.of("m").withModel(ShadingModel.PRINCIPLED).withBase(Rgb.BLACK).withF0(0)
            .withRoughness(1).withCoat(new Coat(1, 0.5, 1.5));
    /** Tilts all normals by 45° about v. */
    private static final Optional<TextureMap> TILTED = map(0.854f, 0.5f, 0.854f);
    private static final BumpMapping TILT = BumpMapping.NONE.withNormalMap(TILTED);

    @Test
    void flatMapOfCoat_changesNothing() {
        Optional<TextureMap> flat = map(0.5f, 0.5f, 1);
        FilmAssert.assertSameBits(trace(scene(COATED.withLayerMaps(LayerMaps.NONE.withCoatNormal(flat)))), trace(scene(COATED)), "flat");
    }

    /** The grazing light of a surface without reflectance is white below the coat, and little: it follows the bumps. */
    @Test
    void coatOverBumps_keepsItsHighlight() {
        Film plain = trace(floor(COATED));
        Film bumped = trace(floor(COATED.withBumpMapping(TILT)));
        Film coat = trace(floor(COATED.withBumpMapping(TILT).withLayerMaps(LayerMaps.NONE.withCoatNormal(TILTED))));
        double same = difference(plain, bumped);
        double other = difference(plain, coat);
        assertThat(other).isGreaterThan(4 * same).isGreaterThan(0.1);
    }

    /** Relative difference of the sums of two pictures of lit floors. */
    private static double difference(Film a, Film b) {
        double sum = 0;
        double total = 0;
        for (int y = 0; y < SurfaceMapsTest.SIZE; y++) {
            for (int x = 0; x < SurfaceMapsTest.SIZE; x++) {
                sum += Math.abs(a.green(x, y) - b.green(x, y));
                total += a.green(x, y);
            }
        }
        return sum / total;
    }

    @Test
    void mirroredRaysOfSmoothCoat_followItsNormals() {
        Material smooth = COATED.withCoat(new Coat(1, 0, 1.5)).withBumpMapping(TILT);
        assertThat(smooth.coatNormals().mirrors()).isTrue();
        assertThat(smooth.withRoughness(0).coatNormals().mirrors()).as("a row has one mirrored ray").isFalse();
        FilmAssert.assertSameBits(trace(scene(smooth)), trace(scene(smooth)), "all renderers");
    }

    @Test
    void coatWithoutBumps_hasNoNormalsOfItsOwn() {
        assertThat(COATED.coatNormals()).isSameAs(CoatNormals.NONE);
        Optional<TextureMap> pixel = Optional.of(new TextureMap("h.png", 1, 1, new Texture(1, 1, new float[] {1, 1, 1})));
        assertThat(COATED.withBumpMapping(BumpMapping.NONE.withBump(pixel)).coatNormals()).isSameAs(CoatNormals.NONE);
        assertThat(COATED.withCoat(Coat.NONE).withBumpMapping(TILT).coatNormals()).isSameAs(CoatNormals.NONE);
    }
}
