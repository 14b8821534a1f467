package lightning.editor.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.editor.document.DeskScene;
import lightning.render.image.Film;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** How much is traced before something of every part of a picture is seen: counted, as times depend on the machine. */
class CoarsePictureTest {
    /** Rays of the eye. Plain loops that nothing has compiled yet take some 0.1 s for a tenth of them. */
    private static final double MAX_RAYS = 32_000;
    private static final double COARSE_RAYS = 2_000;
    private static final double MAX_SIDE = 2500;
    /** What is kept of more need not fit into the memory of a test, and is refused before anything is traced. */
    private static final double MAX_SAMPLES = 10_000_000;

    /** Remembers what is seen first, and has the rest given up. */
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

    @Provide
    Arbitrary<Integer> sides() {
        return Arbitraries.randomValue(random -> (int) Math.exp(Math.log(MAX_SIDE) * random.nextDouble()));
    }

    /** Where all pixels have samples, tiles of the whole picture are what costs; else its centers come first. */
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
            assertThat(first).as("a picture").isNotNull();
            if (rays(picture) < MAX_RAYS) {
                assertThat(first.width()).as("a small picture is not told coarsely first").isEqualTo(width);
            } else {
                assertThat((double) first.width() * first.height()).as("rays")
                        .isLessThanOrEqualTo(Math.max(COARSE_RAYS, longSide(picture)));
                assertThat(look.tiles).as("parts of the picture are seen before the whole of it").isFalse();
            }
        }
    }

    /** Of a picture that is hundreds of times as long as high the coarse one has a line of pixels. */
    private static double longSide(PictureSettings picture) {
        double all = (double) picture.width() * picture.height();
        return Math.max(picture.width(), picture.height()) / Math.sqrt(all / COARSE_RAYS);
    }
}
