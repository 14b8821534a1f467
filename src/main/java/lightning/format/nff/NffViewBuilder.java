package lightning.format.nff;

import java.util.Optional;
import lightning.base.math.Vec3;
import org.jspecify.annotations.Nullable;

/** Mutable builder of a view from its parameters. */
final class NffViewBuilder {
    /** Null until defined, as are the next two. */
    @Nullable
    Vec3 from;
    @Nullable
    Vec3 at;
    @Nullable
    Vec3 up;
    double angle = 45;
    int width;
    int height;

    /** Returns the view; empty if eye point or target is missing. */
    Optional<NffFile.View> build() {
        return from == null || at == null ? Optional.empty()
                : Optional.of(new NffFile.View(from, at, up == null ? Vec3.Y : up, angle, width, height));
    }
}
