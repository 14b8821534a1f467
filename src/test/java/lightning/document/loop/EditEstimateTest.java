package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.UnaryOperator;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.shading.RenderedScenes;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.Test;

class EditEstimateTest {
    private static final int WIDTH = 240;
    private static final int HEIGHT = 160;

    private final Scene scene = DeskScene.scene().withPicture(DeskScene.scene().picture().withSize(WIDTH, HEIGHT));

    private static Film filled(int width, int height, float value) {
        var rgb = new float[width * height * 3];
        java.util.Arrays.fill(rgb, value);
        return Film.ofScanlines(width, height, rgb);
    }

    private static Film withPixel(Film film, int x, int y, float value) {
        var rgb = new float[film.width() * film.height() * 3];
        for (int i = 0; i < film.width() * film.height(); i++) {
            rgb[3 * i] = film.red(i % film.width(), i / film.width());
            rgb[3 * i + 1] = film.green(i % film.width(), i / film.width());
            rgb[3 * i + 2] = film.blue(i % film.width(), i / film.width());
        }
        rgb[3 * (y * film.width() + x)] = value;
        return Film.ofScanlines(film.width(), film.height(), rgb);
    }

    @Test
    void equalCoarsePictures_leaveThePicture() {
        Film last = withPixel(filled(100, 70, 0.3f), 50, 40, 2);
        Film estimate = EditEstimate.of(last, filled(10, 7, 0.5f), filled(10, 7, 0.5f), true);
        for (int y = 0; y < 70; y++) {
            for (int x = 0; x < 100; x++) {
                assertThat(estimate.red(x, y)).isEqualTo(last.red(x, y));
            }
        }
    }

    @Test
    void dimmedLight_keepsDetails() {
        Film last = withPixel(filled(100, 70, 0.5f), 50, 40, 2);
        Film estimate = EditEstimate.of(last, filled(10, 7, 0.5f), filled(10, 7, 0.25f), false);
        assertThat(estimate.red(50, 40)).isEqualTo(1);
        assertThat(estimate.red(10, 10)).isEqualTo(0.25f);
    }

    @Test
    void newLight_isAddedWhereItWasDark() {
        Film estimate = EditEstimate.of(filled(100, 70, 0), filled(10, 7, 0), withPixel(filled(10, 7, 0), 5, 4, 0.5f), false);
        assertThat(estimate.red(55, 45)).isCloseTo(0.5f, within(0.06f));
        assertThat(estimate.red(80, 45)).isZero();
        assertThat(estimate.green(55, 45)).isZero();
    }

    @Test
    void movedShape_replacesDetailsAroundIt() {
        Film last = withPixel(withPixel(filled(100, 70, 0.5f), 52, 42, 9), 12, 42, 9);
        Film estimate = EditEstimate.of(last, filled(10, 7, 0.5f), withPixel(filled(10, 7, 0.5f), 5, 4, 0.2f), true);
        assertThat(estimate.red(52, 42)).isLessThan(0.6f);
        assertThat(estimate.red(12, 42)).as("far away").isEqualTo(9);
    }

    /** Returns the mean difference between a preview of an edited scene and its picture, and that of the picture before the edit. */
    private double[] errors(UnaryOperator<Scene> edit) {
        Scene edited = edit.apply(scene);
        try (var renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            var preview = new EditPreview(renderer);
            preview.setSpeed(100_000);
            EditPreview.Before before = preview.before();
            Film estimate = preview.trace(before, RenderedScenes.of(edited), 1, Progress.NONE);
            renderer.render(edited, Progress.NONE);
            return new double[] {difference(estimate, renderer.film()), difference(before.film(), renderer.film())};
        }
    }

    private static double difference(Film a, Film b) {
        assertThat(a.width()).isEqualTo(b.width());
        double sum = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                sum += Math.abs(a.red(x, y) - b.red(x, y)) + Math.abs(a.green(x, y) - b.green(x, y))
                        + Math.abs(a.blue(x, y) - b.blue(x, y));
            }
        }
        return sum / (3 * WIDTH * HEIGHT);
    }

    @Test
    void previewOfMovedLight_isCloserToItsPictureThanTheLastOne() {
        Light light = scene.lights().getFirst();
        double[] errors = errors(s -> s.withLight(light.withPosition(light.position().plus(new Vec3(0.7, 0.3, 0)))));
        assertThat(errors[0]).isLessThan(errors[1]);
    }

    @Test
    void previewOfMovedCamera_isSmall() {
        Scene moved = scene.withCamera(scene.camera().withOrigin(scene.camera().origin().plus(new Vec3(0.1, 0, 0))));
        try (var renderer = new Renderer(RenderOptions.DEFAULT)) {
            renderer.render(scene, Progress.NONE);
            var preview = new EditPreview(renderer);
            assertThat(preview.trace(preview.before(), RenderedScenes.of(moved), 1, Progress.NONE).width()).isLessThan(WIDTH);
        }
    }
}
