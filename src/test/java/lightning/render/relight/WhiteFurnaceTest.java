package lightning.render.relight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that white principled surfaces in uniform white light reflect all of it: the pixels of a ball in a furnace, a glowing sphere. Rays of a
 * point are 64, so a pixel's own error is the same whatever the light is; the mean over the ball is tested.
 */
class WhiteFurnaceTest {
    private static final String METAL = "base 1 1 1  metalness 1  roughness ";
    private static final String NONMETAL = "base 1 1 1  metalness 0  roughness ";
    private static final String COATED = "base 1 1 1  metalness 1  coat 1  coat_roughness 0.3  roughness ";

    @ParameterizedTest
    @CsvSource({"0", "0.07", "0.08", "0.15", "0.3", "0.5", "0.7", "0.9", "1"})
    void whiteMetal_reflectsAllLight(String roughness) throws JenException {
        assertThat(mean(METAL + roughness)).isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0", "0.07", "0.08", "0.15", "0.3", "0.5", "0.7", "0.9", "1"})
    void whiteNonmetal_sendsAllLightBack(String roughness) throws JenException {
        assertThat(mean(NONMETAL + roughness)).isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0.2, 0", "0.5, 0.5", "0.5, 1", "0.8, 1"})
    void partlyMetal_sendsAllLightBack(String metalness, String roughness) throws JenException {
        assertThat(mean("base 1 1 1  metalness " + metalness + "  roughness " + roughness)).isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0", "0.08", "0.3", "0.6", "1"})
    void coatedSurface_sendsAllLightBack(String roughness) throws JenException {
        assertThat(mean(COATED + roughness)).isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0, 0.3", "0, 0.5", "0, 0.8", "0, 1", "1, 0.5", "0.4, 0.8"})
    void surfaceWithWhiteSheen_sendsAllLightBack(String metalness, String sheenRoughness) throws JenException {
        assertThat(mean("base 1 1 1  roughness 0.7  sheen 1 1 1  metalness " + metalness + "  sheen_roughness " + sheenRoughness))
                .isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0.08, 1", "0.15, 0.5", "0.3, 0.8", "0.3, 1", "0.5, 0.8", "0.7, 0.5", "0.9, 1", "1, 0.8"})
    void brushedMetal_reflectsAllLight(String roughness, String anisotropy) throws JenException {
        assertThat(mean(METAL + roughness + "  anisotropy_rotation 30  anisotropy " + anisotropy)).isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0.5, 0.03", "0.5, 0.4", "0, 0.03"})
    void coatedSurfaceWithWhiteSheen_sendsAllLightBack(String roughness, String coatRoughness) throws JenException {
        assertThat(mean("base 1 1 1  sheen 1 1 1  coat 1  roughness " + roughness + "  coat_roughness " + coatRoughness))
                .isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0.08", "0.15", "0.3", "0.5", "0.7", "0.9", "1"})
    void frostedBody_sendsAllLightOn(String roughness) throws JenException {
        assertThat(mean("base 1 1 1  clear 1 1 1  ior 1.5  roughness " + roughness)).isCloseTo(1, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"0.08", "0.3", "0.6", "1"})
    void frostedSheet_sendsAllLightOn(String roughness) throws JenException {
        assertThat(mean("base 1 1 1  clear 0.5 0.5 0.5  thin yes  coat 0.5  roughness " + roughness, "plane sheet { rotate 90 0 0 "))
                .isCloseTo(1, within(0.01));
    }

    /** Returns the mean of the pixels that show a ball. */
    private static double mean(String material) throws JenException {
        return mean(material, "sphere ball { ");
    }

    /** Returns the mean of the pixels that show a shape of radius 1. */
    private static double mean(String material, String shape) throws JenException {
        Scene scene = JenReader.read("""
                jen 1
                picture { size 24 24  depth 2  indirect { } }
                camera { from 0 0 5  to 0 0 0  fov 20 }
                world { ambience 0 }
                material furnace { diffuse 0 0 0  glow 1 1 1 }
                material white { model principled  %s }
                sphere walls { material furnace  scale 50 50 50 }
                %o material white }
                """.replace("%s", material).replace("%o", shape), "furnace", Path.of(".")).scene();
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            Film film = renderer.film();
            double sum = 0;
            int count = 0;
            for (int y = 0; y < 24; y++) {
                for (int x = 0; x < 24; x++) {
                    // The ball has the radius 1 at the distance 5; its outermost pixels are left out.
                    double angle = Math.tan(Math.toRadians(10)) / 12 * Math.hypot(x - 11.5, y - 11.5);
                    if (Math.sin(Math.atan(angle)) < 0.19) {
                        sum += film.red(x, y);
                        count++;
                    }
                }
            }
            return sum / count;
        }
    }
}
