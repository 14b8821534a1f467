package lightning.render.relight;

import java.util.function.Consumer;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import org.jspecify.annotations.Nullable;

/**
 * Rendering of the small pictures of a {@link MemoryForecast}.
 *
 * @param geometry     geometry to reuse; null to build it
 * @param cancellation cancels the forecast
 * @param listener     receives each picture, for display
 */
record SmallPictures(@Nullable Geometry geometry, Progress cancellation, Consumer<Film> listener) {
    /** Builds its own geometry and shows nothing. */
    static final SmallPictures UNSEEN = new SmallPictures(null, Progress.NONE, _ -> {});
}
