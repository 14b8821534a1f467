package lightning.review;

import java.util.List;
import java.util.stream.IntStream;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/** Frames of a shot on a review page. */
public final class ReviewFilm {
    /** Number of frames if none are named. */
    public static final int FRAMES = 8;
    /** Largest width of a frame if no size is named, in pixels. */
    public static final int WIDTH = 480;

    private ReviewFilm() {}

    /** Returns evenly spaced frames, the first and the last among them. */
    public static List<Integer> frames(Shot shot) {
        int count = shot.last() - shot.first() + 1;
        int shown = Math.min(FRAMES, count);
        return IntStream.range(0, shown).map(i -> shot.first() + (int) Math.round((double) i * (count - 1) / Math.max(1, shown - 1)))
                .boxed()
                .toList();
    }

    /** Returns a scene whose picture is not wider than {@link #WIDTH}. */
    public static Scene reduced(Scene scene) {
        PictureSettings picture = scene.picture();
        if (picture.width() <= WIDTH) {
            return scene;
        }
        int height = Math.max(1, Math.round((float) picture.height() * WIDTH / picture.width()));
        return scene.withPicture(picture.withSize(WIDTH, height));
    }
}
