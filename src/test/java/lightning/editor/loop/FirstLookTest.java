package lightning.editor.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Wait;
import lightning.editor.document.Desk;
import lightning.render.image.Film;
import lightning.render.relight.tile.Options;
import lightning.scene.Antialias;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;

/** How much is traced before something of every part of a picture is seen: counted, as times depend on the machine. */
class FirstLookTest {
    /** Rays of the eye. Plain loops that nothing has compiled yet take some 0.1 s for a tenth of them. */
    private static final double MOST_RAYS = 32_000;
    private static final double COARSE_RAYS = 2_000;
    private static final double MOST_SIDE = 2500;
    /** What is kept of more need not fit into the memory of a test, and is refused before anything is traced. */
    private static final double MOST_SAMPLES = 10_000_000;

    /** Remembers what is seen first, and has the rest given up. */
    private static final class FirstLook implements RenderListener {
        private final BlockingQueue<Film> seen = new LinkedBlockingQueue<>();
        private volatile RenderLoop loop;
        private volatile boolean tiles;

        @Override
        public void coarse(Film film, Scene scene) {
            seen.add(film);
            loop.cancel();
        }

        @Override
        public void tile(Scene scene, int tile, float[][] film) {
            tiles = true;
        }

        @Override
        public void rendered(Frame frame) {
            seen.add(frame.film());
        }
    }

    @Provide
    Arbitrary<Integer> sides() {
        return Arbitraries.randomValue(random -> (int) Math.exp(Math.log(MOST_SIDE) * random.nextDouble()));
    }

    /** Where all pixels have samples, tiles of the whole picture are what costs; else its centres come first. */
    private static double rays(Picture picture) {
        return (double) picture.width() * picture.height()
                * (picture.sampling().antialias() == Antialias.EVERY ? picture.sampling().perPixel() : 1);
    }

    @Property(tries = 40)
    void somethingOfEveryPart_isSeenAfterAFewRaysWhateverThePicture(@ForAll("sides") int width, @ForAll("sides") int height,
            @ForAll Antialias antialias, @ForAll @IntRange(min = 2, max = 8) int grid) throws Exception {
        Scene scene = Desk.scene();
        Picture picture = scene.picture().withSize(width, height).withSampling(new Sampling(antialias, grid));
        Assume.that(rays(picture) <= MOST_SAMPLES);
        var look = new FirstLook();
        try (var loop = new RenderLoop(Options.DEFAULT.withThreads(1), look)) {
            look.loop = loop;
            loop.render(scene.withPicture(picture));
            Film first = look.seen.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS);
            assertThat(first).as("a picture").isNotNull();
            if (rays(picture) < MOST_RAYS) {
                assertThat(first.width()).as("a small picture is not told coarsely first").isEqualTo(width);
            } else {
                assertThat((double) first.width() * first.height()).as("rays")
                        .isLessThanOrEqualTo(Math.max(COARSE_RAYS, longSide(picture)));
                assertThat(look.tiles).as("parts of the picture are seen before the whole of it").isFalse();
            }
        }
    }

    /** Of a picture that is hundreds of times as long as high the coarse one has a line of pixels. */
    private static double longSide(Picture picture) {
        double all = (double) picture.width() * picture.height();
        return Math.max(picture.width(), picture.height()) / Math.sqrt(all / COARSE_RAYS);
    }
}
