package lightning.document.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.document.DeskScene;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** Number of rays before every part of an image is visible; counted, as times depend on the machine. */
class CoarsePictureTest {
    /** Maximum number of eye rays. Interpreted scalar loops take about 0.1 s for a tenth of them. */
    private static final double MAX_RAYS = 32_000;
    private static final double COARSE_RAYS = 2_000;
    private static final double MAX_SIDE = 2500;
    /** Maximum number of samples: a larger cache may exceed a test's memory and be refused before tracing. */
    private static final double MAX_SAMPLES = 10_000_000;

    /** Records the first visible image and cancels the rest. */
    private static final class CoarsePictureListener implements RenderListener {
        private final BlockingQueue<Film> films = new LinkedBlockingQueue<>();
        private volatile RenderLoop loop;
        private volatile boolean tiles;

        @Override
        public void coarseRendered(Film film, Scene scene) {
            films.add(film);
            loop.cancel();
        }

        @Override
        public void tileRendered(Scene scene, int tile, float[][] film) {
            tiles = true;
        }

        @Override
        public void rendered(Frame frame) {
            films.add(frame.film());
        }
    }

    @Example
    void preview_showsSceneOfOtherSizeOnly() {
        Scene scene = DeskScene.scene().withPicture(new PictureSettings(400, 300, 1));
        CoarsePicture preview = CoarsePicture.first(scene, RenderOptions.DEFAULT, _ -> {}).orElseThrow();
        Scene larger = scene.withPicture(scene.picture().withSize(800, 600).withSampling(new SamplingSettings(AntialiasMode.EDGES, 4)));
        assertThat(preview.shows(larger)).isTrue();
        assertThat(preview.shows(larger.withPicture(larger.picture().withDepth(2)))).isFalse();
        assertThat(preview.shows(larger.withLights(List.of()))).isFalse();
    }

    @Provide
    Arbitrary<Integer> sides() {
        return Arbitraries.randomValue(random -> (int) Math.exp(Math.log(MAX_SIDE) * random.nextDouble()));
    }

    /**
     * Returns the eye rays of an image before its edges are refined: all samples if every pixel is supersampled, otherwise one per pixel.
     */
    private static double rays(PictureSettings picture) {
        return (double) picture.width() * picture.height()
                * (picture.sampling().antialias() == AntialiasMode.EVERY ? picture.sampling().samplesPerPixel() : 1);
    }

    @Property(tries = 40)
    void somethingOfEveryPart_isSeenAfterAFewRaysWhateverThePicture(@ForAll("sides") int width, @ForAll("sides") int height,
            @ForAll AntialiasMode antialias, @ForAll @IntRange(min = 2, max = 8) int grid) throws Exception {
        Scene scene = DeskScene.scene();
        PictureSettings picture = scene.picture().withSize(width, height).withSampling(new SamplingSettings(antialias, grid));
        Assume.that(rays(picture) <= MAX_SAMPLES);
        var look = new CoarsePictureListener();
        try (var loop = new RenderLoop(RenderOptions.DEFAULT.withThreads(1), look)) {
            look.loop = loop;
            loop.render(scene.withPicture(picture));
            Film first = look.films.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            assertThat(first).as("image").isNotNull();
            if (rays(picture) < MAX_RAYS) {
                assertThat(first.width()).as("small image without a coarse one").isEqualTo(width);
            } else {
                assertThat((double) first.width() * first.height()).as("rays")
                        .isLessThanOrEqualTo(Math.max(COARSE_RAYS, longSide(picture)));
                assertThat(look.tiles).as("tiles before the first full image").isFalse();
            }
        }
    }

    /** Returns the long side for an extreme aspect ratio, whose coarse image is a single line of pixels. */
    private static double longSide(PictureSettings picture) {
        double all = (double) picture.width() * picture.height();
        return Math.max(picture.width(), picture.height()) / Math.sqrt(all / COARSE_RAYS);
    }
}
