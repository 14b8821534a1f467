package lightning.format.nff;

import java.util.Optional;
import lightning.base.math.Vec3;

/** What a file says of its view, as it comes. */
final class NffViewBuilder {
    /** Null until the file says it, like the next two. */
    Vec3 from;
    Vec3 at;
    Vec3 up;
    double angle = 45;
    int width;
    int height;

    /** None where the file does not say from where to where. */
    Optional<NffFile.View> build() {
        return from == null || at == null ? Optional.empty()
                : Optional.of(new NffFile.View(from, at, up == null ? Vec3.Y : up, angle, width, height));
    }
}
