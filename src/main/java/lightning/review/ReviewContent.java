package lightning.review;

import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import lightning.base.text.Language;
import lightning.render.image.ViewTransform;
import lightning.scene.Contribution;
import lightning.scene.Scene;

/**
 * What a review page shows.
 *
 * @param title    name of the scene
 * @param base     scene without keyframes applied, whose intensities and colors a review names
 * @param pictures one picture, or frames of a shot
 * @param language language of the page; empty for that of the browser
 */
public record ReviewContent(String title, Scene base, List<ReviewPicture> pictures, ViewTransform view, Optional<Language> language) {
    /** Layers of a picture: graphics hardware has room for at least 256. */
    private static final int MAX_LAYERS = 256;
    /** Size of a page that browsers open. */
    private static final long MAX_BYTES = 500_000_000;
    /** Share of the bytes of halves that remains after compression, and the growth by Base64, about. */
    private static final double COMPRESSION = 0.55 * 4 / 3;

    /** Returns the content of a page with one picture, in the language of the browser. */
    public static ReviewContent of(String title, ReviewPicture picture, ViewTransform view) {
        return new ReviewContent(title, picture.scene(), List.of(picture), view, Optional.empty());
    }

    /** Returns the bytes of a page, about. */
    public long estimatedBytes() {
        double bytes = 0;
        for (ReviewPicture picture : pictures) {
            double pixels = picture.pixels() + (hasThumbnails() ? Thumbnail.pixels(picture.scene().picture()) : 0);
            bytes += COMPRESSION * 6 * pixels * layers(picture);
        }
        return Math.round(bytes);
    }

    boolean hasThumbnails() {
        return pictures.size() > 1;
    }

    private static int layers(ReviewPicture picture) {
        return Contribution.shining(picture.scene()).size() + 1 + picture.fixedLooks().size();
    }

    /**
     * Checks that a page has room for this, before anything is rendered.
     *
     * @throws IOException if not; the message is a sentence for the user
     */
    public void check() throws IOException {
        for (ReviewPicture picture : pictures) {
            if (layers(picture) > MAX_LAYERS) {
                throw new IOException("a review page has room for " + (MAX_LAYERS - 1)
                        + " lights that shine and pictures of looks, the scene has " + (layers(picture) - 1));
            }
        }
        if (estimatedBytes() > MAX_BYTES) {
            throw new IOException(String.format(Locale.ROOT,
                    "a review page has at most %d MB, this one would have about %d; choose a smaller picture, fewer frames or fewer looks",
                    MAX_BYTES / 1_000_000, estimatedBytes() / 1_000_000));
        }
    }

    /** Returns all lights that shine in a picture, in the order of the scene; environments come last. */
    public List<Contribution> lights() {
        Set<Contribution> shining = new HashSet<>();
        pictures.forEach(picture -> shining.addAll(Contribution.shining(picture.scene())));
        return Contribution.sources(base).stream().filter(shining::contains).toList();
    }

    /** Returns the names of these lights. */
    public List<String> lightNames() {
        return lights().stream().map(light -> light.name(base)).toList();
    }
}
